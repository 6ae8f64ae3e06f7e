#pragma once
/// @file standing_view.hpp
/// What ./cs550 progress shows of a student's standing.

#include <limits>

#include "standing.hpp"

namespace cs550::cli {

/// Every lab with its points, the engine's milestones, and the next step; in 24 lines of 80 columns.
void print_overview(const Standing& standing);

/// The next step, and what stands in its way.
/// @param lines at most so many of the reason
void print_next(const Standing& standing, int lines = std::numeric_limits<int>::max());

/// Every test of the next lab.
void print_tests(const Standing& standing);

/// One hint more for the next step. @returns the exit code
int print_hint(const Standing& standing);

}  // namespace cs550::cli
