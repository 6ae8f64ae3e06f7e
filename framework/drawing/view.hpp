#pragma once
/// @file view.hpp
/// From where a drawing is seen.

#include "cs550/math.hpp"

namespace cs550::drawing {

/// A point of view. The scale is not part of it: what is framed always fills the picture.
struct View {
  Vec3 toward_eye = {Real(1.3), Real(-2.4), Real(1.3)};  ///< from the target, any length
  Vec3 up = Vec3::UnitZ();                               ///< upward on the page, roughly
  Real field_of_view = 0;  ///< vertical angle (rad); 0 draws parallel lines parallel
  Bounds frame;            ///< what must be visible (m); empty: all of the drawing
};

/// Along a coordinate axis: a plan and a front view.
/// @{
inline View view_from_above() { return {{0, 0, 1}, {0, 1, 0}, 0, {}}; }
inline View view_from_front() { return {{0, -1, 0}, {0, 0, 1}, 0, {}}; }
/// @}

/// A size on the page.
struct Size {
  double width = 640;   ///< pixels
  double height = 480;  ///< pixels
};

}  // namespace cs550::drawing
