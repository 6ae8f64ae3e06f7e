#pragma once
/// @file power_law.hpp

#include <span>

namespace cs550::bench {

/// The cost of a problem of size n.
struct Cost {
  double n = 0;
  double seconds = 0;
};

/// cost = factor·n^exponent
struct PowerLaw {
  double factor = 0;
  double exponent = 0;
};

/// The line of least squares through (log n, log cost).
/// @param costs positive, of at least two different sizes; else std::invalid_argument is thrown
PowerLaw fit_power_law(std::span<const Cost> costs);

}  // namespace cs550::bench
