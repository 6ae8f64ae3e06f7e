#include "benchmarks/quality/hull_overlap.hpp"

#include <algorithm>
#include <limits>

namespace cs550::bench {
namespace {

using Eigen::Vector3d;

/// Newell's method.
PlacedHull::Face face_of(const HalfEdgeMesh& mesh, Index face,
                         const std::vector<Vector3d>& vertices) {
  Vector3d area = Vector3d::Zero();
  Vector3d centre = Vector3d::Zero();
  double count = 0;
  for (const Index e : face_edges(mesh, face)) {
    const Vector3d& from = vertices[static_cast<std::size_t>(mesh.origin(e))];
    const Vector3d& to = vertices[static_cast<std::size_t>(mesh.edge(e).vertex)];
    area += from.cross(to);
    centre += from;
    ++count;
  }
  const Vector3d normal = area.normalized();
  return {normal, normal.dot(centre) / count};
}

/// The smallest overlap along the face normals of `a`; 0 if one of them separates.
double overlap_along_faces(const PlacedHull& a, const PlacedHull& b) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const PlacedHull::Face& face : a.faces) {
    double overlap = 0;
    for (const Vector3d& vertex : b.vertices) {
      overlap = std::max(overlap, face.offset - face.normal.dot(vertex));
    }
    if (overlap <= 0) return 0;
    smallest = std::min(smallest, overlap);
  }
  return smallest;
}

/// Whether the arcs of two edges cross on the Gauss maps of A and −B.
/// @param a_turn cross product of the normals beside A's edge
/// @param b_turn the same of the negated normals beside B's edge
bool arcs_cross(const PlacedHull::Edge& a, const Vector3d& a_turn, const PlacedHull::Edge& b,
                const Vector3d& b_turn) {
  const double left_of_a = -b.left.dot(a_turn), right_of_a = -b.right.dot(a_turn);
  const double left_of_b = a.left.dot(b_turn), right_of_b = a.right.dot(b_turn);
  return left_of_a * right_of_a < 0 && left_of_b * right_of_b < 0 && left_of_a * right_of_b > 0;
}

/// The overlap along the common perpendicular of two edges; infinite if they are parallel.
double overlap_along_edges(const PlacedHull::Edge& a, const PlacedHull::Edge& b) {
  constexpr double parallel = 1e-6;
  Vector3d axis = a.vector.cross(b.vector);
  const double length = axis.norm();
  if (length < parallel * a.vector.norm() * b.vector.norm())
    return std::numeric_limits<double>::infinity();
  axis /= length;
  if (axis.dot(a.left + a.right) < 0) axis = -axis;
  return axis.dot(a.origin - b.origin);
}

double overlap_along_edges(const PlacedHull& a, const PlacedHull& b) {
  std::vector<Vector3d> turns;
  turns.reserve(b.edges.size());
  for (const PlacedHull::Edge& edge : b.edges) turns.push_back(edge.right.cross(edge.left));
  double smallest = std::numeric_limits<double>::infinity();
  for (const PlacedHull::Edge& edge_a : a.edges) {
    const Vector3d turn = edge_a.right.cross(edge_a.left);
    for (std::size_t i = 0; i < b.edges.size(); ++i) {
      if (!arcs_cross(edge_a, turn, b.edges[i], turns[i])) continue;
      smallest = std::min(smallest, overlap_along_edges(edge_a, b.edges[i]));
    }
  }
  return std::max(0.0, smallest);
}

}  // namespace

PlacedHull::PlacedHull(const ConvexShape& shape, const BodyMotion& motion) {
  const HalfEdgeMesh& mesh = shape.mesh;
  const Eigen::Matrix3d rotation = motion.orientation.normalized().toRotationMatrix();
  for (const Vec3& vertex : mesh.vertices) {
    vertices.emplace_back(rotation * vertex.cast<double>() + motion.position);
  }
  lower = upper = vertices.front();
  for (const Vector3d& vertex : vertices) {
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
  }
  for (Index f = 0; f < mesh.face_count(); ++f) faces.push_back(face_of(mesh, f, vertices));
  const auto normal_left_of = [&](Index e) {
    return faces[static_cast<std::size_t>(mesh.edge(e).face)].normal;
  };
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    const Vector3d& origin = vertices[static_cast<std::size_t>(mesh.origin(e))];
    const Vector3d& end = vertices[static_cast<std::size_t>(mesh.edge(e).vertex)];
    edges.push_back({origin, end - origin, normal_left_of(e), normal_left_of(e ^ 1)});
  }
}

bool bounds_overlap(const PlacedHull& a, const PlacedHull& b) {
  return (a.lower.array() <= b.upper.array()).all() && (b.lower.array() <= a.upper.array()).all();
}

double penetration_depth(const PlacedHull& a, const PlacedHull& b) {
  const double along_a = overlap_along_faces(a, b);
  if (along_a <= 0) return 0;
  const double along_b = overlap_along_faces(b, a);
  if (along_b <= 0) return 0;
  return std::min({along_a, along_b, overlap_along_edges(a, b)});
}

}  // namespace cs550::bench
