#pragma once
/// @file exact_separation.hpp
/// The separation of two bodies by brute force in double precision: over all vertices, all face
/// normals and all pairs of edges, without Gauss maps or hill climbing.

#include <algorithm>
#include <cmath>
#include <vector>

#include "cs550/convex_shape.hpp"

namespace cs550::test {

using Vec3d = Eigen::Vector3d;

/// A posed shape in double precision, relative to a given point of the world, so that it is exact
/// even at large world coordinates.
struct ExactBody {
  std::vector<Vec3d> vertices;  ///< relative to that point (m)
  std::vector<Vec3d> normals;   ///< by face, world frame
  std::vector<Vec3d> edges;     ///< unit, by number of the edge (half-edge / 2), world frame
  double size = 0;              ///< distance of the farthest vertex from the body's origin (m)

  ExactBody(const PosedShape& body, const Vec3& viewer);
};

/// min over B of n·b − max over A of n·a: the separation along the axis n (A → B).
double separation_along(const ExactBody& a, const ExactBody& b, const Vec3d& axis);

/// The largest separations by brute force, or −infinity if there is no axis of a kind.
struct BestSeparations {
  double face_a = -HUGE_VAL;
  double face_b = -HUGE_VAL;
  double edges = -HUGE_VAL;     ///< over both directions of every cross product of two edges
  Vec3d axis = Vec3d::UnitZ();  ///< of the largest of all, A → B

  double faces() const { return std::max(face_a, face_b); }
  double largest() const { return std::max(faces(), edges); }
};
BestSeparations best_separations(const ExactBody& a, const ExactBody& b);

}  // namespace cs550::test
