#pragma once
/// @file primitives.hpp
/// Shapes made from a few numbers, and hulls of point clouds.

#include <span>
#include <string>
#include <vector>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// Vertices and triangles, counter-clockwise seen from outside: what files, generators and hulls
/// hand to build_half_edge_mesh().
struct TriangleSoup {
  std::vector<Vec3> vertices;       ///< any frame (m)
  std::vector<Triangle> triangles;  ///< of indices of vertices
};

/// A box about the origin. @param half_extents m, positive
TriangleSoup box_soup(const Vec3& half_extents);
/// The corner tetrahedron (0,0,0), (s,0,0), (0,s,0), (0,0,s).
TriangleSoup tetrahedron_soup(Real side);
/// A right prism over a regular n-gon about the origin, its axis along z. @param sides ≥ 3
TriangleSoup prism_soup(int sides, Real radius, Real half_height);
/// A pyramid over a regular n-gon in the plane z = 0, its apex on the z axis. @param sides ≥ 3
TriangleSoup pyramid_soup(int sides, Real radius, Real height);
/// An icosahedron whose triangles are split into four `subdivisions` times, on a sphere about the
/// origin: 10·4^subdivisions + 2 vertices.
TriangleSoup icosphere_soup(int subdivisions, Real radius);

/// A triangle soup, or a sentence that says why there is none.
struct SoupResult {
  TriangleSoup soup;  ///< empty if there is an error
  std::string error;  ///< empty if there is a soup
};

/// The convex hull of a point cloud by qhull (Barber, Dobkin & Huhdanpaa 1996). Refuses fewer than
/// four points, coplanar points and points that are not finite.
SoupResult convex_hull(std::span<const Vec3> points);

/// `count` points on the unit sphere from a seeded generator, the same on every platform; their hull
/// has them all as vertices.
std::vector<Vec3> random_sphere_points(int count, std::uint32_t seed);

}  // namespace cs550
