#pragma once
/// @file palette.hpp
/// The meaning of colours, shared by the pictures of tests, the viewer and the book.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cs550::drawing {

/// The meaning of an element in a drawing. It determines the colour.
enum class Role : std::uint8_t {
  BodyA,      ///< the first body, its normals, its Gauss map
  BodyB,      ///< the second body; of −B on a common Gauss map
  Reference,  ///< the face whose side planes clip
  Incident,   ///< the face that is clipped
  Highlight,  ///< the subject: the current half-edge, a crossing, an impulse
  Expected,   ///< the correct result, beside Got
  Got,        ///< the result of the code under test
  Warning,    ///< a violated postcondition
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
/// Design* (2008). People with colour blindness can distinguish them.
Colour colour(Role role);

/// Whether lines of this role need a dark outline on white, like yellow lines.
bool needs_outline(Role role);

/// The number of roles that series_role() gives before it begins again.
inline constexpr std::size_t series_role_count = 6;

/// Roles for items that only need different colours, such as the curves of a plot. They repeat
/// after the last.
Role series_role(int index);

/// The background of every picture.
inline constexpr Colour paper = {255, 255, 255};

/// Mixes two colours: share 0 gives `a`, share 1 gives `b`.
Colour mix(Colour a, Colour b, double share);

/// As written in SVG and CSS: "#0072b2".
std::string hex(Colour colour);

}  // namespace cs550::drawing
