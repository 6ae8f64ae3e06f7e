#pragma once
/// @file area.hpp
/// Sizes and areas in pixels.

#include "cs550/math.hpp"

namespace cs550::pages {

/// The size of a picture or a window.
struct Size {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  bool operator==(const Size& other) const = default;
};

/// A part of a picture, in pixels from its top left corner.
struct Area {
  float left = 0;    ///< pixels
  float top = 0;     ///< pixels
  float width = 0;   ///< pixels
  float height = 0;  ///< pixels

  /// The centre.
  Vec2 center() const { return {left + width / 2, top + height / 2}; }
};

}  // namespace cs550::pages
