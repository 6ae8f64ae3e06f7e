#include "gradebook/reports/shown.hpp"

#include <fmt/format.h>

namespace cs550::gradebook {

std::string engine_heading(const StudentMark& mark) {
  const EngineMark& engine = mark.engine;
  if (engine.record == nullptr || !engine.record->engine->submitted) return {};
  return fmt::format("Engine: {} of {} milestones reached", engine.reached, engine.of);
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
