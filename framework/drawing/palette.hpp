#pragma once
/// @file palette.hpp
/// What a colour means, in one place, so that pictures of tests, the viewer and the book agree.

#include <array>
#include <cstdint>
#include <string>

namespace cs550::drawing {

/// What an element of a drawing stands for. Its colour follows.
enum class Role : std::uint8_t {
  BodyA,      ///< the first body, its normals, its Gauss map
  BodyB,      ///< the second body; of −B on a common Gauss map
  Reference,  ///< the face that others are clipped against
  Incident,   ///< the face that is clipped
  Highlight,  ///< look here: the current half-edge, a crossing, an impulse
  Expected,   ///< what is right, beside Got
  Got,        ///< what came out
  Warning,    ///< a broken promise
  Axis,       ///< separating axes, normals, coordinate axes
  Faint,      ///< context that should not distract
  Text,       ///< labels, outlines
};

/// sRGB, 0–255.
struct Colour {
  std::uint8_t red = 0;    ///< 0–255
  std::uint8_t green = 0;  ///< 0–255
  std::uint8_t blue = 0;   ///< 0–255

  /// Whether both are the same colour.
  bool operator==(const Colour& other) const {
    return red == other.red && green == other.green && blue == other.blue;
  }
};

/// All roles, in the order of the enumeration.
inline constexpr std::array<Role, 11> all_roles = {
    Role::BodyA, Role::BodyB,   Role::Reference, Role::Incident, Role::Highlight, Role::Expected,
    Role::Got,   Role::Warning, Role::Axis,      Role::Faint,    Role::Text};

/// The colour of a role on a light background. The hues are those of Okabe & Ito, *Color Universal
/// Design* (2008), which people with any kind of colour vision tell apart.
Colour colour(Role role);

/// Whether lines of this role need a dark outline to be seen on white: yellow does.
bool needs_outline(Role role);

/// Roles for things that are only to be told apart, such as the curves of a plot; after the last
/// they start again.
Role series_role(int index);

/// The background of every picture.
inline constexpr Colour paper = {255, 255, 255};

/// A share of `b` in `a`: 0 gives a, 1 gives b.
Colour mix(Colour a, Colour b, double share);

/// As written in SVG and CSS: "#0072b2".
std::string hex(Colour colour);

}  // namespace cs550::drawing
