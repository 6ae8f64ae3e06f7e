#pragma once
/// @file painting_order.hpp
/// The painter's algorithm: from back to front, so that nearer elements cover farther ones.

#include <vector>

#include "drawing/fitted_view.hpp"

namespace cs550::drawing {

/// One stroke of the brush: an element of a drawing, or a part of a line.
struct BrushStroke {
  /// The list of the drawing that contains the element.
  enum class Kind : std::uint8_t { Polygon, Ball, Line, Point };
  Kind kind = Kind::Point;  ///< the list of the drawing
  std::size_t index = 0;    ///< index in that list
  double from = 0;          ///< of a line: where this part begins, 0–1 along it
  double to = 1;            ///< of a line: where it ends
};

/// Up to this many polygons the order is exact.
inline constexpr std::size_t exact_polygons = 1500;

/// The elements of a drawing from back to front. Polygons and balls are compared where they overlap
/// on the page. If that order is cyclic, as for polygons that intersect, they are sorted by their
/// middles. A line is cut where its visibility changes, and each part is painted just before the
/// first polygon that hides it, so that hidden lines are exact (Appel 1967). Points are treated
/// alike. O(n²) in the number of polygons. @pre coordinates are finite
std::vector<BrushStroke> painting_order(const Drawing& drawing, const FittedView& view);

}  // namespace cs550::drawing
