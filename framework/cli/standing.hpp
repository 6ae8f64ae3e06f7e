#pragma once
/// @file standing.hpp
/// Where a student stands: what ./cs550 progress finds out before it shows anything.

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lab_result.hpp"

namespace cs550::cli {

/// All labs, and the first of them that is not finished.
struct Standing {
  std::vector<LabResult> labs;
  std::set<std::string> untouched;  ///< labs that are still the starter
  std::optional<std::size_t> next;
  std::set<int> milestones;  ///< labs whose milestones the assembled engine reaches
};

/// Grades the labs whose files have changed, and runs the assembled engine. Nothing is built for a
/// lab that was not begun, unless it is the next one. Says on a terminal what it is at.
Standing look_at_labs();

}  // namespace cs550::cli
