#pragma once
/// @file view.hpp
/// The viewpoint of a drawing.

#include "cs550/math.hpp"

namespace cs550::drawing {

/// A viewpoint. It has no scale, because the frame always fills the picture.
struct View {
  Vec3 toward_eye = {Real(1.3), Real(-2.4), Real(1.3)};  ///< from the target, any length
  Vec3 up = Vec3::UnitZ();                               ///< upward on the page, roughly
  Real field_of_view = 0;  ///< vertical angle (rad); 0 for a parallel projection
  Bounds frame;            ///< the part to show (m); if empty, the whole drawing
  /// Fits the ball inside the frame instead of its corners, so that the scale stays the same while
  /// the view turns.
  bool frames_ball = false;
};

/// Views along a coordinate axis.
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
