#pragma once
/// @file minkowski_drawing.hpp
/// **Lab 4:** The Minkowski difference of two bodies. Document §3.3.

#include "cs550/convex_shape.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// A − B: the polyhedron of all differences a − b, and the origin. The bodies overlap if and only if
/// it holds the origin; then the distance to its nearest face is the depth. Faces of A, faces of −B
/// and those of pairs of edges have different colours: they are the points and the crossings of the
/// two Gauss maps. O(pairs of edges · vertices): meant for shapes of up to about 100 vertices.
Drawing draw_minkowski_difference(const PosedShape& a, const PosedShape& b);

}  // namespace cs550::drawing
