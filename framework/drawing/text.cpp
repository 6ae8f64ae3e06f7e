#include "drawing/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cs550::drawing {
namespace {

const char* superscript(char letter) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return letter == '-' ? "⁻" : digits[letter - '0'];
}

}  // namespace

std::string with_minus_sign(std::string number) {
  if (!number.starts_with('-')) return number;
  const bool is_zero = number.find_first_not_of("-0.") == std::string::npos;
  return number.replace(0, 1, is_zero ? "" : "−");
}

std::string number_text(double value, int digits) {
  return with_minus_sign(fmt::format("{:.{}g}", value, digits));
}

std::string length_text(double meters) {
  return std::abs(meters) < 0.1 ? number_text(1000 * meters) + " mm" : number_text(meters) + " m";
}

std::string power_of_ten_text(int exponent) {
  if (std::abs(exponent) <= 3) return number_text(std::pow(10.0, exponent), 4);
  std::string text = "10";
  for (const char letter : std::to_string(exponent)) text += superscript(letter);
  return text;
}

}  // namespace cs550::drawing
