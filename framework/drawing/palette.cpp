#include "drawing/palette.hpp"

#include <cmath>

namespace cs550::drawing {
namespace {

constexpr Colour orange = {0xE6, 0x9F, 0x00};
constexpr Colour sky_blue = {0x56, 0xB4, 0xE9};
constexpr Colour bluish_green = {0x00, 0x9E, 0x73};
constexpr Colour yellow = {0xF0, 0xE4, 0x42};
constexpr Colour blue = {0x00, 0x72, 0xB2};
constexpr Colour vermilion = {0xD5, 0x5E, 0x00};
constexpr Colour reddish_purple = {0xCC, 0x79, 0xA7};
constexpr Colour dark_grey = {0x40, 0x44, 0x4C};
constexpr Colour light_grey = {0xB4, 0xB8, 0xBF};
constexpr Colour near_black = {0x1B, 0x1E, 0x23};

}  // namespace

Colour colour(Role role) {
  switch (role) {
    case Role::BodyA:
      return blue;
    case Role::BodyB:
      return orange;
    case Role::Reference:
      return sky_blue;
    case Role::Incident:
      return reddish_purple;
    case Role::Highlight:
      return yellow;
    case Role::Expected:
      return bluish_green;
    case Role::Got:
    case Role::Warning:
      return vermilion;
    case Role::Axis:
      return dark_grey;
    case Role::Faint:
      return light_grey;
    case Role::Text:
      return near_black;
  }
  return near_black;
}

bool needs_outline(Role role) { return role == Role::Highlight; }

Role series_role(int index) {
  constexpr std::array<Role, series_role_count> roles = {
      Role::BodyA, Role::Got, Role::Expected, Role::Incident, Role::BodyB, Role::Reference};
  return roles.at(index % roles.size());
}

Colour mix(Colour a, Colour b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround((1 - share) * from + share * to));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

std::string hex(Colour colour) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
    text += digits[channel >> 4];
    text += digits[channel & 15];
  }
  return text;
}

}  // namespace cs550::drawing
