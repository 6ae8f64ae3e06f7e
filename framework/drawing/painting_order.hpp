#pragma once
/// @file painting_order.hpp
/// What is painted first: from back to front, so that what is nearer covers what is farther.

#include <vector>

#include "drawing/fitted_view.hpp"

namespace cs550::drawing {

/// One stroke of the brush: an element of a drawing, or a part of a line.
struct BrushStroke {
  /// Which list of the drawing the element is in.
  enum class Kind : std::uint8_t { Polygon, Ball, Line, Point };
  Kind kind = Kind::Point;  ///< which list of the drawing
  std::size_t index = 0;    ///< place in that list
  double from = 0;          ///< of a line: where this part begins, 0–1 along it
  double to = 1;            ///< of a line: where it ends
};

/// Up to this many polygons the order is exact.
inline constexpr std::size_t exact_polygons = 1500;

/// The elements of a drawing from back to front. Polygons and balls are ordered by which is nearer
/// where they overlap on the page (by their middles where that is circular, as for polygons that
/// pierce each other). A line is cut where its visibility changes, and each part comes just before
/// the first polygon that hides it: hidden lines are exact (Appel 1967). Points likewise. Expects
/// finite coordinates. O(n²) in the number of polygons.
std::vector<BrushStroke> painting_order(const Drawing& drawing, const FittedView& view);

}  // namespace cs550::drawing
