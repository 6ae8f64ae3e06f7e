#pragma once
/// @file milestones.hpp
/// Running a submission's labs together, as one engine.

#include <nlohmann/json.hpp>

#include "autograder/grader/grade_lab/options.hpp"

namespace cs550::grader {

/// Compiles labs 1 to `options.lab` and runs their milestones in the judge, which compares them with
/// the recorded reference. The starter takes the place of a lab that does not compile, and of later
/// labs.
/// @return a record of the same form as that of a lab, with lab 0; a milestone has no points
nlohmann::ordered_json run_milestones(const Options& options);

}  // namespace cs550::grader
