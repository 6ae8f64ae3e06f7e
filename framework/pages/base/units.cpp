#include "pages/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/text.hpp"

namespace cs550::pages {
namespace {

struct Prefix {
  double factor;
  const char* name;
};

/// Some units take no prefix: "kg·m/s" contains one already.
Prefix prefix_for(double magnitude, const std::string& unit) {
  constexpr std::array<Prefix, 5> prefixes{
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}}};
  const bool takes_prefix =
      unit == "J" || unit == "N·s" || unit == "m" || unit == "N" || unit == "s";
  if (!takes_prefix || magnitude == 0) return {1, ""};
  for (const Prefix& prefix : prefixes) {
    const bool metres = unit == "m" && prefix.factor > 1;
    if (!metres && magnitude >= prefix.factor) return prefix;
  }
  return prefixes.back();
}

std::string three_digits(double value) {
  const double magnitude = std::abs(value);
  if (magnitude >= 1e6) return drawing::number_text(value);
  const int decimals = magnitude < 10 ? 2 : magnitude < 100 ? 1 : 0;
  return drawing::with_minus_sign(fmt::format("{:.{}f}", value, decimals));
}

std::string with_unit(const std::string& number, const Prefix& prefix, const std::string& unit) {
  const std::string name = prefix.name + unit;
  return name.empty() ? number : number + " " + name;
}

}  // namespace

std::string quantity(double value, const std::string& unit) {
  const Prefix prefix = prefix_for(std::abs(value), unit);
  return with_unit(three_digits(value / prefix.factor), prefix, unit);
}

std::string quantity(const Vec3& value, const std::string& unit) {
  const Prefix prefix = prefix_for(static_cast<double>(value.cwiseAbs().maxCoeff()), unit);
  const auto component = [&](int i) {
    return three_digits(static_cast<double>(value[i]) / prefix.factor);
  };
  return with_unit("(" + component(0) + ", " + component(1) + ", " + component(2) + ")", prefix,
                   unit);
}

}  // namespace cs550::pages
