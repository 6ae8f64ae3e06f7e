#pragma once
/// @file record.hpp
/// The record of a submission, from which every report is made.

#include <optional>
#include <string>
#include <vector>

#include "gradebook/intake/submission.hpp"

namespace cs550::gradebook {

struct TestResult {
  std::string name;  ///< "Lab3.FirstOfEqualVerticesWins"
  std::string step;  ///< "L3.1"
  int points = 0;
  int earned = 0;
  /// passed, failed, blocked, crashed, timeout, not_compiled or not_submitted
  std::string status;
  bool hidden = false;
  double seconds = 0;
  std::string message;
  std::string picture;  ///< of the case that fails, as SVG; empty for most tests
};

/// What a challenge counts on a submission that passes every test of the lab.
struct ChallengeResult {
  std::string what;  ///< "vertices visited by 2000 climbs from the same vertex"
  bool fewer_is_better = true;
  long count = 0;
};

/// What the tests that a student has written are worth.
struct OwnTests {
  bool compiled = false;
  int mistakes = 0;  ///< known ones of the lab
  int caught = 0;    ///< of these; 0 if a test ever fails on the reference
  bool fails_reference = false;
  std::string message;     ///< of the compiler, or what a test prints that fails on the reference
  std::string not_graded;  ///< why the grader itself failed; empty if they were graded
  /// Whether a run, or the compiler, was stopped for its time or for lack of memory.
  bool stopped = false;
};

struct LabRecord {
  int lab = 0;
  bool submitted = false;
  std::string hash;  ///< of its files
  std::string
      same_as;  ///< the record of equal files whose result this is; empty if graded for this one
  std::vector<std::string> files;     ///< that were graded
  std::vector<std::string> supplied;  ///< starter files that were missing and were added
  std::string isolation, compiler, seed;
  bool compiled = false;
  double compile_seconds = 0;
  std::string compile_errors;
  std::vector<TestResult> tests;
  std::optional<OwnTests>
      own_tests;  ///< empty without them, or if the course has no points for them
  std::vector<ChallengeResult> challenge;  ///< empty if the leaderboard does not show it
  /// Why the grader itself failed. The lab has no mark then; empty if it was graded.
  std::string not_graded;

  int points() const;
  int earned() const;
  double seconds() const;                           ///< of compilation and tests
  int tests_with(const std::string& status) const;  ///< the number with that status
  bool has_test(const std::string& name) const;
  bool is_graded() const;  ///< whether the grader failed in no part of it
  /// Not if the compiler was stopped: the tests are timeouts then.
  bool fails_to_compile() const { return !compiled && tests_with("timeout") == 0; }
  /// Whether grading the same files again would give the same: a timeout, or own tests that were
  /// stopped, may be those of a busy machine.
  bool is_final() const;
};

struct Record {
  std::string name, source, student;
  bool is_identified = false;        ///< whether a platform named the student, not a file or folder
  std::string path;                  ///< of the source: tells submissions with equal names apart
  std::vector<std::string> folders;  ///< around the source that may be a student's, outermost first
  std::string claimed_student, claimed_date, starter;
  std::optional<long> file_time;  ///< seconds since 1970: when it was handed in, if that is known
  std::string hash;
  std::string project;  ///< commit of the instructor's copy
  std::vector<LabRecord> labs;
  std::vector<IgnoredFile> ignored;
  std::string trouble;  ///< why the submission could not be read

  /// The milestones of labs 1, 2, ... together, as tests without points; empty if they were not run.
  std::optional<LabRecord> engine;

  bool is_graded() const;  ///< whether the grader failed on no lab, and not on the milestones
  /// Null if the record does not include that lab.
  const LabRecord* lab(int number) const;
};

}  // namespace cs550::gradebook
