#pragma once
/// @file engine_score.hpp
/// The second score: a lab is graded by itself, but do the student's labs run together?

#include <set>
#include <vector>

#include "lab_result.hpp"

namespace cs550::cli {

/// Whether a lab has a milestone: a recorded run of the reference.
bool has_milestone(int lab);

/// The labs whose milestones the student's engine reaches. Runs them when a lab file or the
/// framework has changed, else remembers them in build/results/engine.json.
/// @param labs those that were begun, from the first on
std::set<int> milestones_reached(const std::vector<LabResult>& labs);

}  // namespace cs550::cli
