#pragma once
/// @file standing.hpp
/// All that `progress` reports: the results of the labs, and the milestones of the assembled
/// engine.

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/grading/lab_result.hpp"

namespace cs550::cli {

struct Standing {
  std::vector<LabResult> labs;
  std::set<std::string> untouched;  ///< labs that are still the starter
  std::optional<std::size_t> next;  ///< the first lab that is not finished, in `labs`
  std::set<int> milestones;         ///< labs whose milestones the student's engine reaches
  /// Why the machine could not build the engine, so that its milestones are not known. Empty if it could, or if the
  /// student's code does not compile: then no milestone is reached.
  std::string engine_fault;
};

/// Grades the labs that have changed and runs the student's engine. Nothing is built for an
/// untouched lab, unless it is the next one. On a terminal a status line shows what is running.
Standing look_at_labs();

/// Whether a lab has a milestone: a recorded run of the reference.
bool has_milestone(int lab);

}  // namespace cs550::cli
