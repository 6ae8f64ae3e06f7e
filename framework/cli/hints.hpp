#pragma once
/// @file hints.hpp
/// Hints, one at a time.

#include <string>

namespace cs550::cli {

/// Shows a hint of a step from the handout.
/// @param number 1, 2, 3; 0 shows the one after the last that was shown, which
///        build/results/hints.json remembers
/// @return an ExitCode: Misused when the handout has no such hint
int show_hint(const std::string& lab_name, const std::string& tag, int number);

}  // namespace cs550::cli
