#pragma once
/// @file minkowski_drawing.hpp
/// **Lab 4:** The Minkowski difference of two bodies. Document §3.3.

#include "cs550/convex_shape.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// A − B: the polyhedron of all differences a − b, and the origin. The bodies overlap if and only
/// if the polyhedron contains the origin. The depth is then the distance to the nearest face. Faces
/// of A, faces of −B and faces of edge pairs have different colours. They correspond to the points
/// and the crossings of the two Gauss maps. It is computed as the convex hull of all vertex pairs
/// and is meant for shapes of up to about 100 vertices.
Drawing draw_minkowski_difference(const PosedShape& a, const PosedShape& b);

}  // namespace cs550::drawing
