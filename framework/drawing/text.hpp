#pragma once
/// @file text.hpp
/// Numbers as people write them.

#include <string>

namespace cs550::drawing {

/// A number with so many significant digits and a true minus sign: "−0.426". Never "−0".
std::string number_text(double value, int digits = 3);

/// A length in the unit that suits it: "12 mm", "1.2 m". @param meters signed
std::string length_text(double meters);

/// 10ⁿ: "0.001", "1", "100", beyond that "10⁻⁶".
std::string power_of_ten_text(int exponent);

}  // namespace cs550::drawing
