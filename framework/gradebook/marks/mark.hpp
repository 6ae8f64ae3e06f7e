#pragma once
/// @file mark.hpp
/// From points to marks: scale, late policy, adjustments, regrades, weights.

#include <string>
#include <vector>

#include "gradebook/marks/roster.hpp"

namespace cs550::gradebook {

struct LabMark {
  int lab = 0;
  const Record* record = nullptr;  ///< the one that counts; null if nothing was submitted
  int earned = 0;                  ///< of the project's points, with granted regrades
  int of = 0;                      ///< the project's points
  double points = 0;               ///< what the lab is worth in the course
  double bonus = 0;                ///< points for the student's own tests
  double late_days = 0;            ///< days begun after the due date
  double deduction = 0;            ///< points lost for being late
  double adjustment = 0;           ///< points given or taken by hand
  double mark = 0;                 ///< of `points`
  bool is_graded = true;           ///< false if the grader failed
  bool was_run = true;             ///< false if no run graded this lab for the student
  std::vector<std::string> notes;  ///< everything that changed the mark, in words

  const LabRecord* lab_record() const { return record == nullptr ? nullptr : record->lab(lab); }
};

/// How many milestones the student's engine reaches, in the record in which it reaches most.
struct EngineMark {
  const Record* record = nullptr;  ///< null if no engine was graded
  int reached = 0;
  int too_late = 0;         ///< reached, but only after the solution of their lab was released
  int of = 0;               ///< milestones of all labs that were graded for anybody
  bool is_graded = true;    ///< false if the grader failed
  bool was_run = true;      ///< false if they have a weight, and only other students' were run
  bool has_weight = false;  ///< whether milestones count in the course

  /// Milestones that no run has run for the student, but for others.
  int not_run() const {
    return record == nullptr ? 0 : of - static_cast<int>(record->engine->tests.size());
  }
};

struct StudentMark {
  Student student;
  std::vector<LabMark> labs;
  double percent = 0;  ///< weighted
  EngineMark engine;

  bool is_missing() const { return student.records.empty(); }
  /// Whether submissions are there, and can be read, but have no lab that is graded.
  bool has_no_lab() const;
  bool is_graded() const;
  /// Whether the milestones were run, and no submission has all labs that the student handed in.
  bool has_scattered_labs() const;
  const LabMark* lab(int number) const;
};

/// Why milestones may be missing, and what to do about it.
inline constexpr const char* milestones_need_one_submission =
    "milestones need all labs in one submission: ./cs550 submit without a number packs them";

/// Notes on a lab without a submission.
inline constexpr const char* note_not_submitted = "not submitted";
inline constexpr const char* note_not_run =
    "counts as 0, but no run graded it for this student: --labs left it out";

/// Note on a student without milestones in a class that has them.
inline constexpr const char* note_no_milestones =
    "milestones count as 0, but no run has run them for this student";

/// The labs of all records, ascending.
std::vector<int> labs_of(const std::vector<Record>& records);

StudentMark mark_student(const Student& student, const std::vector<int>& labs,
                         const Course& course);

std::vector<StudentMark> mark_class(const std::vector<Student>& students,
                                    const std::vector<int>& labs, const Course& course);

/// Whether the milestones of anybody were run, also if the grader failed.
bool have_engines(const std::vector<StudentMark>& marks);

/// The entries of the course file whose student is neither the id nor the email of anybody:
/// "[[extension]] of lab 3 for s0109".
std::vector<std::string> entries_about_nobody(const Course& course,
                                              const std::vector<Student>& students);

/// "the tests give 47 of 60 points, which count as 78.33 of 100"; empty if points count as they are.
std::string note_on_scale(const LabMark& mark);

/// A mark as people write it: "47.5", "60".
std::string points_text(double points);

}  // namespace cs550::gradebook
