#include "gradebook/reports/grades_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gradebook/text/escape.hpp"

namespace cs550::gradebook {
namespace {

/// Submissions that could not be read, of a student with another one that could.
std::string damaged_ones(const Student& student) {
  std::string notes;
  for (const Record* record : student.records) {
    if (record->trouble.empty()) continue;
    notes += fmt::format("{}damaged: {}: {}", notes.empty() ? "" : "; ", plain_line(record->source),
                         plain_line(record->trouble));
  }
  return notes;
}

/// What an instructor may want to look at before publishing a mark.
std::vector<std::string> troubles_of(const LabRecord& lab) {
  if (!lab.submitted) return {};
  if (!lab.not_graded.empty()) return {"the grader: " + plain_line(lab.not_graded)};
  if (lab.fails_to_compile()) return {"does not compile"};
  std::vector<std::string> troubles;
  if (lab.own_tests && !lab.own_tests->not_graded.empty()) {
    troubles.push_back("the grader, of my_tests.cpp: " + plain_line(lab.own_tests->not_graded));
  }
  if (lab.own_tests && lab.own_tests->stopped) {
    troubles.emplace_back("my_tests.cpp was stopped: grade again if the machine was busy");
  }
  const auto add = [&](const char* status, const char* what) {
    const int count = lab.tests_with(status);
    if (count == 0) return;
    troubles.push_back(fmt::format("{} test{} {}", count, count == 1 ? "" : "s", what));
  };
  add("crashed", "crashed");
  add("timeout", "ended at the limit of time: grade again if the machine was busy");
  return troubles;
}

std::string notes_of(const StudentMark& mark) {
  const std::string trouble = trouble_of(mark.student);
  std::string notes = trouble.empty() ? damaged_ones(mark.student) : trouble;
  const auto add = [&](const std::string& note) {
    notes += fmt::format("{}{}", notes.empty() ? "" : "; ", note);
  };
  if (mark.has_scattered_labs()) add(milestones_need_one_submission);
  if (!mark.engine.was_run) add(note_no_milestones);
  if (const int count = mark.engine.not_run(); count > 0) {
    add(fmt::format("{} milestone{} not reached: no run has run {} for this student", count,
                    count == 1 ? " counts as" : "s count as", count == 1 ? "it" : "them"));
  }
  if (!mark.engine.is_graded) add("milestones NOT GRADED: the grader failed");
  if (const int late =
          mark.engine.record == nullptr ? 0 : mark.engine.record->engine->tests_with("timeout");
      late > 0) {
    add(fmt::format("{} milestone{} ended at the limit of time: grade again with a larger one",
                    late, late == 1 ? "" : "s"));
  }
  if (const int late = mark.engine.too_late; late > 0) {
    add(fmt::format("{} milestone{} reached after the solution was released: no points for {}",
                    late, late == 1 ? "" : "s", late == 1 ? "it" : "them"));
  }
  for (const LabMark& lab : mark.labs) {
    for (const std::string& note : lab.notes) {
      if (note != note_not_submitted) add(fmt::format("lab {}: {}", lab.lab, plain_line(note)));
    }
    if (lab.lab_record() == nullptr) continue;
    for (const std::string& note : troubles_of(*lab.lab_record())) {
      add(fmt::format("lab {}: {}", lab.lab, note));
    }
  }
  return notes;
}

}  // namespace

std::string trouble_of(const Student& student) {
  std::string trouble;
  for (const Record* record : student.records) {
    if (record->trouble.empty()) return {};
    trouble = record->trouble;
  }
  return trouble;
}

std::string status_of(const StudentMark& mark) {
  if (mark.is_missing()) return "missing";
  if (!mark.is_graded()) return "NOT GRADED";
  if (!trouble_of(mark.student).empty()) return "unreadable";
  if (!mark.student.on_roster) return "not on the roster";
  return mark.has_no_lab() ? "no graded lab" : "graded";
}

std::string grades_csv(const std::vector<StudentMark>& marks, const std::vector<int>& labs) {
  std::string text = "id,name,email,section,status,percent";
  for (const int lab : labs) text += fmt::format(",lab{}", lab);
  const bool has_engines = have_engines(marks);
  text += has_engines ? ",milestones,notes\n" : ",notes\n";
  for (const StudentMark& mark : marks) {
    const Student& student = mark.student;
    text += fmt::format("{},{},{},{},{},{}", csv(student.id), csv(student.name), csv(student.email),
                        csv(student.section), status_of(mark),
                        mark.is_graded() ? fmt::format("{:.2f}", mark.percent) : "");
    for (const LabMark& lab : mark.labs) {
      // An empty field differs from a zero that was earned.
      text +=
          ',' +
          (lab.is_graded && (lab.record != nullptr || lab.mark > 0) ? points_text(lab.mark) : "");
    }
    if (has_engines) {
      const bool has_number = mark.engine.record != nullptr && mark.engine.is_graded;
      text += ',' + (has_number ? std::to_string(mark.engine.reached) : "");
    }
    text += ',' + csv(notes_of(mark)) + '\n';
  }
  return text;
}

}  // namespace cs550::gradebook
