#pragma once
/// @file hull_overlap.hpp
/// How deep two convex hulls are in each other, in double precision and without the labs' code.

#include <Eigen/Core>
#include <vector>

#include "benchmarks/quality/body_motion.hpp"
#include "cs550/convex_shape.hpp"

namespace cs550::bench {

/// A hull in the world frame, with normals recomputed in double precision.
struct PlacedHull {
  struct Face {
    Eigen::Vector3d normal;  ///< unit, outward
    double offset;           ///< of its plane (m)
  };
  struct Edge {
    Eigen::Vector3d origin;       ///< one of its ends (m)
    Eigen::Vector3d vector;       ///< to its other end (m)
    Eigen::Vector3d left, right;  ///< normals of its faces
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  Eigen::Vector3d lower, upper;  ///< bounds

  PlacedHull(const ConvexShape& shape, const BodyMotion& motion);
};

/// Whether the bounds of two hulls overlap.
bool bounds_overlap(const PlacedHull& a, const PlacedHull& b);

/// The length of the shortest translation that separates two hulls (m): 0 if they are apart. The
/// smallest overlap over all face normals and over the cross products of all edges that form a face
/// of the Minkowski difference (Gregorius 2013).
double penetration_depth(const PlacedHull& a, const PlacedHull& b);

}  // namespace cs550::bench
