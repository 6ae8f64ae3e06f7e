#include "gradebook/reports/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace cs550::gradebook {

std::vector<TestResult> by_step(std::vector<TestResult> tests) {
  const auto number = [](const TestResult& test) {  // 10 of "L2.10"
    const std::size_t point = test.step.find('.');
    return point == std::string::npos ? 0 : std::atoi(test.step.c_str() + point + 1);
  };
  std::stable_sort(tests.begin(), tests.end(),
                   [&](const auto& a, const auto& b) { return number(a) < number(b); });
  return tests;
}

std::string without_hidden_names(std::string note, const LabRecord& lab) {
  constexpr std::string_view instead = "a hidden test";
  for (const TestResult& test : lab.tests) {
    if (!test.hidden) continue;
    for (auto at = note.find(test.name); at != note.npos; at = note.find(test.name)) {
      note.replace(at, test.name.size(), instead);
    }
  }
  return note;
}

std::string lab_heading(const LabMark& mark) {
  if (!mark.is_graded) return fmt::format("Lab {}: not graded", mark.lab);
  return fmt::format("Lab {}: {} of {} points", mark.lab, points_text(mark.mark),
                     points_text(mark.points));
}

std::string engine_heading(const StudentMark& mark) {
  const EngineMark& engine = mark.engine;
  if (engine.record == nullptr || !engine.record->engine->submitted) return {};
  if (!engine.is_graded) return "Engine: not graded";
  const std::string late =
      engine.too_late == 0
          ? ""
          : fmt::format(", {} more after the solution was released", engine.too_late);
  return fmt::format("Engine: {} of {} milestones reached{}", engine.reached, engine.of, late);
}

std::string missing_labs(const StudentMark& mark) {
  std::string labs;
  for (const LabMark& lab : mark.labs) {
    if (lab.record == nullptr) labs += fmt::format("{}lab {}", labs.empty() ? "" : ", ", lab.lab);
  }
  if (labs.empty()) return {};
  const std::string missing = "Not in this submission: " + labs;
  return mark.engine.record == nullptr ? missing
                                       : missing + ". Note that " + milestones_need_one_submission;
}

}  // namespace cs550::gradebook
