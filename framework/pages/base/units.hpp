#pragma once
/// @file units.hpp
/// Numbers as people read them.

#include <string>

#include "cs550/math.hpp"

namespace cs550::pages {

/// A value with its unit and a prefix that leaves one to three digits before the point:
/// quantity(12300, "J") is "12.3 kJ".
std::string quantity(double value, const std::string& unit);

/// Three components with a common prefix: "(1.00, −2.50, 0.00) kg·m/s".
std::string quantity(const Vec3& value, const std::string& unit);

}  // namespace cs550::pages
