#pragma once
/// @file challenge.hpp
/// The counts of a lab's challenges: the student's beside those of the reference.

#include <string>
#include <vector>

#include "cli/grading/lab_result.hpp"

namespace cs550::cli {

/// The reference's counts, as tests/labN_topic/manifest.json lists them.
std::vector<ChallengeCount> reference_counts(const std::string& lab_name);

/// Runs the student's code of a lab that is built. Throws std::runtime_error if that crashes or does not
/// end.
std::vector<ChallengeCount> students_counts(int lab);

/// Prints two lines for each challenge.
void print_counts(const std::vector<ChallengeCount>& yours,
                  const std::vector<ChallengeCount>& reference);

}  // namespace cs550::cli
