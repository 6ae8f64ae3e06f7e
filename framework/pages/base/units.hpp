#pragma once
/// @file units.hpp
/// Quantities with SI prefixes.

#include <string>

#include "cs550/math.hpp"

namespace cs550::pages {

/// A value with its unit and a prefix such that one to three digits are before the decimal point:
/// quantity(12300, "J") is "12.3 kJ".
std::string quantity(double value, const std::string& unit);

/// Three components with the same prefix: "(1.00, −2.50, 0.00) kg·m/s".
std::string quantity(const Vec3& value, const std::string& unit);

}  // namespace cs550::pages
