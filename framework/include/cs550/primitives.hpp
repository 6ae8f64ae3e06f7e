#pragma once
/// @file primitives.hpp
/// Generators of simple shapes, and convex hulls of point clouds. The generators throw
/// std::invalid_argument for a length that is not positive and finite, and for a count outside its
/// range; the message names it.

#include <span>
#include <string>
#include <vector>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// Vertices and triangles, counter-clockwise seen from outside: the input of
/// build_half_edge_mesh(), as files, generators and hulls produce it.
struct TriangleSoup {
  std::vector<Vec3> vertices;       ///< any frame (m)
  std::vector<Triangle> triangles;  ///< indices into vertices
};

/// A box centred at the origin. @param half_extents m, positive
TriangleSoup box_soup(const Vec3& half_extents);
/// The tetrahedron with corners (0,0,0), (s,0,0), (0,s,0) and (0,0,s). @param side s (m)
TriangleSoup tetrahedron_soup(Real side);
/// A right prism over a regular polygon, centred at the origin, with its axis along z.
/// @param sides 3–10,000 @param radius of the corners about the axis (m) @param half_height m
TriangleSoup prism_soup(int sides, Real radius, Real half_height);
/// A pyramid over a regular polygon in the plane z = 0, with its apex on the z axis.
/// @param sides 3–10,000 @param radius of the base's corners about the axis (m) @param height m
TriangleSoup pyramid_soup(int sides, Real radius, Real height);
/// Every triangle split into four at the middles of its edges. The surface does not change.
TriangleSoup split_at_middles(const TriangleSoup& coarse);
/// An approximation of a sphere about the origin: an icosahedron with each triangle split into four
/// `subdivisions` times. It has 10·4^subdivisions + 2 vertices.
/// @param subdivisions 0–8 @param radius m
TriangleSoup icosphere_soup(int subdivisions, Real radius);

/// A triangle soup, or an error message.
struct SoupResult {
  TriangleSoup soup;  ///< empty on error
  std::string error;  ///< empty on success
};

/// The convex hull of a point cloud, by qhull (Barber, Dobkin & Huhdanpaa 1996). Rejects fewer than
/// four points, coplanar points, points that are not finite, and hulls so thin that floats cannot
/// tell the normals of their sides: each needs 1/10000 of its length as its width. Points that make
/// narrower triangles are removed if no more than 1 % of the volume is lost.
SoupResult convex_hull(std::span<const Vec3> points);

/// `count` points on the unit sphere from a seeded generator, equal on every platform. All of them
/// are vertices of their convex hull.
std::vector<Vec3> random_sphere_points(int count, std::uint32_t seed);

}  // namespace cs550
