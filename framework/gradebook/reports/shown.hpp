#pragma once
/// @file shown.hpp
/// What a report for a student shows of a test.

#include <string>
#include <vector>

#include "gradebook/course/course.hpp"
#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// The message of a test; never that of a hidden one.
inline std::string shown_message(const TestResult& test) {
  return test.hidden ? std::string() : test.message;
}

/// The tests of a lab in the order of its steps; those of one step as they are.
std::vector<TestResult> by_step(std::vector<TestResult> tests);

/// Whether feedback lists the hidden tests, by name and points, or only their sum.
inline bool lists_hidden_tests(const Course& course) {
  return course.hidden_tests != Visibility::Hidden;
}

/// A note without the names of hidden tests.
std::string without_hidden_names(std::string note, const LabRecord& lab);

/// A note on a lab in feedback.
inline std::string note_in_feedback(const std::string& note, const LabMark& mark,
                                    const Course& course) {
  const bool hides = mark.lab_record() != nullptr && !lists_hidden_tests(course);
  return hides ? without_hidden_names(note, *mark.lab_record()) : note;
}

/// "crashed" for crashed, "not compiled" for not_compiled.
inline std::string status_text(const TestResult& test) {
  std::string text = test.status;
  for (char& c : text) c = c == '_' ? ' ' : c;
  return text;
}

/// What is said above the messages of the compiler: "does not compile".
inline std::string compile_verdict(const LabRecord& lab) {
  return lab.fails_to_compile() ? "does not compile" : "was not compiled";
}

/// "Lab 3: 48 of 60 points", or "Lab 3: not graded" if the grader failed.
std::string lab_heading(const LabMark& mark);

/// "Engine: 7 of 9 milestones reached", and how many too late, or "Engine: not graded" if the grader failed; empty if
/// the submission has no engine.
std::string engine_heading(const StudentMark& mark);

/// "reached", "not reached", or its status_text().
inline std::string milestone_text(const TestResult& milestone) {
  if (milestone.status == "passed") return "reached";
  return milestone.status == "failed" ? "not reached" : status_text(milestone);
}

/// "Not in this submission: lab 1, lab 2", and what that means for milestones, if they were run; empty if every
/// lab that was graded is there.
std::string missing_labs(const StudentMark& mark);

}  // namespace cs550::gradebook
