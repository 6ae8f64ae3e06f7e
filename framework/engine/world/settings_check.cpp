#include "cs550/setting_range.hpp"

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

#include "engine/world/settings_ranges.hpp"

namespace cs550 {

namespace {

template <class Number>
[[noreturn]] void refuse(const char* name, const std::string& expected, Number found) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the setting " << name << " needs " << expected << "; found " << found;
  throw std::invalid_argument(text.str());
}

void check_number(const char* name, Real value, Range range) {
  if (!fits(static_cast<double>(value), range)) refuse(name, in_words(range), value);
}

void check_number(const char* name, const Vec3& value, Range range) {
  for (const Real number : value) check_number(name, number, range);
}

template <class Number, class Bound>
void check_number(const char* name, Number value, Bound least, Bound most) {
  // Not a number is outside, too. The bounds are those of the member's type: 1.9 is not a float.
  if (value >= static_cast<Number>(least) && value <= static_cast<Number>(most)) return;
  std::ostringstream range;
  range.imbue(std::locale::classic());
  range << "a number from " << least << " to " << most;
  refuse(name, range.str(), value);
}

template <class Number>
SettingRange in_numbers(Number least, Number most) {
  return {static_cast<Real>(least), static_cast<Real>(most)};
}

SettingRange in_numbers(Range range) {
  const auto [least, most] = ends(range);
  return in_numbers(least, most);
}

}  // namespace

std::optional<SettingRange> setting_range(std::string_view name) {
  const WorldSettings settings;
  std::optional<SettingRange> found;
  for_each_range(settings, [&](const char* each, const auto& /*value*/, auto... range) {
    if (name == each) found = in_numbers(range...);
  });
  return found;
}

void check(const WorldSettings& settings) {
  for_each_range(settings, [](const char* name, const auto& value, auto... range) {
    check_number(name, value, range...);
  });
}

}  // namespace cs550
