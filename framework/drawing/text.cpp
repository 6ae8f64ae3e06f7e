#include "drawing/text.hpp"

#include <cmath>
#include <cstdio>

namespace cs550::drawing {
namespace {

const char* superscript(char letter) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return letter == '-' ? "⁻" : digits[letter - '0'];
}

}  // namespace

std::string number_text(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*g", digits, std::abs(value));
  const std::string magnitude = text;
  return std::signbit(value) && magnitude != "0" ? "−" + magnitude : magnitude;
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
