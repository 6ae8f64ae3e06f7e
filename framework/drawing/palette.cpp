#include "drawing/palette.hpp"

#include <cmath>

namespace cs550::drawing {
namespace {

constexpr Color orange = {0xE6, 0x9F, 0x00};
constexpr Color sky_blue = {0x56, 0xB4, 0xE9};
constexpr Color bluish_green = {0x00, 0x9E, 0x73};
constexpr Color yellow = {0xF0, 0xE4, 0x42};
constexpr Color blue = {0x00, 0x72, 0xB2};
constexpr Color vermilion = {0xD5, 0x5E, 0x00};
constexpr Color reddish_purple = {0xCC, 0x79, 0xA7};
constexpr Color dark_grey = {0x40, 0x44, 0x4C};
constexpr Color light_grey = {0xB4, 0xB8, 0xBF};
constexpr Color near_black = {0x1B, 0x1E, 0x23};

}  // namespace

Color color(Role role) {
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
  constexpr std::array<Role, 6> roles = {Role::BodyA,    Role::Got,   Role::Expected,
                                         Role::Incident, Role::BodyB, Role::Reference};
  return roles.at(static_cast<std::size_t>(index) % roles.size());
}

Color mix(Color a, Color b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround((1 - share) * from + share * to));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

std::string hex(Color color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
    text += digits[channel >> 4];
    text += digits[channel & 15];
  }
  return text;
}

}  // namespace cs550::drawing
