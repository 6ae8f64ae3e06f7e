#pragma once
/// @file test_report.hpp
/// What a graded test reports: one block for all of its failed checks, and, when the code under
/// test crashes or never returns, the case in which that happened.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::autograder {

/// A property and the case in which it is checked, in words.
struct TestCase {
  std::string property;             ///< a sentence
  std::vector<std::string> given;   ///< facts: "mesh cube", "start = 4"
  std::vector<std::string> when;    ///< what was done
  std::vector<std::string> causes;  ///< what most likely went wrong
  bool is_random = false;           ///< its numbers come from a seed
};

/// A check that does not hold.
struct FailedCheck {
  TestCase at;
  std::string what;  ///< what was checked, "v_B"
  std::string expected;
  std::string got;
  std::string picture;  ///< file, may be empty
};

/// The block of text for a test's failed checks: the simplest failing case, the number of similar
/// ones, and each likely cause once; the cause that the most failing cases share comes first.
std::string summary(const std::vector<FailedCheck>& checks);

/// The failed checks of the running test, in the order of time.
const std::vector<FailedCheck>& failed_checks();

/// Whether no failed check of the running test has a case as simple as this one. A case is simpler
/// when it is not random, then when it takes fewer characters to describe: a cube before prism32, 1
/// body before 10.
bool is_simplest_so_far(const TestCase& at);

/// Adds a failed check to the running test. @param file, line of the check
void report_failure(const FailedCheck& check, const char* file, int line);

/// The texts of the running test's failures that are no failed checks: exceptions, unwritten
/// functions.
std::vector<std::string> other_failures();

/// The case that the code under test runs in, as text. It is noted at once, in memory that outlives
/// the program if CaseFile gave it a file.
/// @{
/// @param at a case without a property empties the note
void note_case(const TestCase& at);
/// A check of the case held: what happens from here on may belong to the next case.
void note_passed_check();
std::string noted_case();
/// @}

/// A file that holds noted_case() while this object lives, and afterwards if the program crashes or
/// is killed. Where it cannot be made, there is none.
class CaseFile {
 public:
  /// @param file is made; removed at the end
  explicit CaseFile(std::filesystem::path file);
  ~CaseFile();
  CaseFile(const CaseFile&) = delete;
  CaseFile& operator=(const CaseFile&) = delete;

 private:
  std::filesystem::path file_;
};

}  // namespace cs550::autograder
