#pragma once
/// @file text.hpp
/// Formatted numbers.

#include <string>

namespace cs550::drawing {

/// Replaces the hyphen of a negative number by a true minus sign, and drops the sign of a zero.
std::string with_minus_sign(std::string number);

/// A number with this many significant digits and a true minus sign: "−0.426".
std::string number_text(double value, int digits = 3);

/// A length in mm or m: "12 mm", "1.2 m". @param meters signed
std::string length_text(double meters);

/// 10ⁿ as "0.001", "1", "100", or for |n| > 3 as "10⁻⁶".
std::string power_of_ten_text(int exponent);

}  // namespace cs550::drawing
