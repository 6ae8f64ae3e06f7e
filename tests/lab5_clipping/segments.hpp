#pragma once
/// @file segments.hpp
/// The distance of two segments by brute force over their features, in double precision.

#include <algorithm>

#include "lab5_clipping/contacts.hpp"

namespace cs550::test {

inline double point_to_segment(const Point& point, const Point& from, const Point& to) {
  const Point along = to - from;
  const double t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from + t * along - point).norm();
}

/// The minimum over the distances of each end from the other segment and, if the closest points of
/// the two lines are inside both segments, the distance of the lines.
inline double segment_distance(const Point& a0, const Point& a1, const Point& b0, const Point& b1) {
  double smallest = std::min({point_to_segment(a0, b0, b1), point_to_segment(a1, b0, b1),
                              point_to_segment(b0, a0, a1), point_to_segment(b1, a0, a1)});
  Eigen::Matrix3d frame;
  frame << a1 - a0, b0 - b1, (a1 - a0).cross(b1 - b0).normalized();
  const Point solution = frame.inverse() * (b0 - a0);  // s, t, signed distance of the lines
  const bool inside =
      solution.x() >= 0 && solution.x() <= 1 && solution.y() >= 0 && solution.y() <= 1;
  if (inside) smallest = std::min(smallest, std::abs(solution.z()));
  return smallest;
}

/// Checks the anchors of an edge contact: each on its edge, as far apart as the edges are.
inline void require_closest_points(Story& story, const PosedShape& a, const PosedShape& b,
                                   const SeparatingAxis& axis, const Manifold& manifold, Real size,
                                   SourceLine at = {}) {
  require(story.expect_equal("points", manifold.points.size(), 1, at));
  const HalfEdgeMesh& mesh_a = a.mesh();
  const HalfEdgeMesh& mesh_b = b.mesh();
  const Index edge_a = axis.edges.edge_a;
  const Index edge_b = axis.edges.edge_b;
  const Point a0 = in_world(a, mesh_a.vertex(mesh_a.origin(edge_a)));
  const Point a1 = in_world(a, mesh_a.vertex(mesh_a.edge(edge_a).vertex));
  const Point b0 = in_world(b, mesh_b.vertex(mesh_b.origin(edge_b)));
  const Point b1 = in_world(b, mesh_b.vertex(mesh_b.edge(edge_b).vertex));
  const Point p_a = on_a(a, manifold.points[0]);
  const Point p_b = on_b(b, manifold.points[0]);
  // A dozen roundings of float relative to the size of the pair.
  const double rounding = 5e-6 * static_cast<double>(size);
  require(story.expect_near("distance of anchor_a from A's edge", point_to_segment(p_a, a0, a1), 0,
                            rounding, "m", at));
  require(story.expect_near("distance of anchor_b from B's edge", point_to_segment(p_b, b0, b1), 0,
                            rounding, "m", at));
  require(story.expect_near("distance between the anchors, against that of the segments",
                            (p_b - p_a).norm(), segment_distance(a0, a1, b0, b1), rounding, "m",
                            at));
}

}  // namespace cs550::test
