#include "helpers/exact_separation.hpp"

#include <algorithm>

namespace cs550::test {

ExactBody::ExactBody(const PosedShape& body, const Vec3& viewer) {
  const HalfEdgeMesh& mesh = body.mesh();
  const Eigen::Matrix3d rotation =
      body.pose.orientation.cast<double>().normalized().toRotationMatrix();
  const Vec3d position = body.pose.position.cast<double>() - viewer.cast<double>();
  for (const Vec3& v : mesh.vertices) {
    vertices.push_back(rotation * v.cast<double>() + position);
    size = std::max(size, double{v.norm()});
  }
  for (const Face& face : mesh.faces) {
    normals.push_back(rotation * face.plane.normal.cast<double>().normalized());
  }
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    edges.push_back(rotation * mesh.edge_vector(e).cast<double>().normalized());
  }
}

double separation_along(const ExactBody& a, const ExactBody& b, const Vec3d& axis) {
  double end_of_a = -HUGE_VAL;
  double begin_of_b = HUGE_VAL;
  for (const Vec3d& v : a.vertices) end_of_a = std::max(end_of_a, axis.dot(v));
  for (const Vec3d& v : b.vertices) begin_of_b = std::min(begin_of_b, axis.dot(v));
  return begin_of_b - end_of_a;
}

BestSeparations best_separations(const ExactBody& a, const ExactBody& b) {
  BestSeparations best;
  double largest = -HUGE_VAL;
  const auto try_axis = [&](double& best_of_kind, const Vec3d& axis) {
    const double separation = separation_along(a, b, axis);
    best_of_kind = std::max(best_of_kind, separation);
    if (separation > largest) {
      largest = separation;
      best.axis = axis;
    }
  };
  for (const Vec3d& n : a.normals) try_axis(best.face_a, n);
  for (const Vec3d& n : b.normals) try_axis(best.face_b, -n);
  for (const Vec3d& edge_a : a.edges) {
    for (const Vec3d& edge_b : b.edges) {
      const Vec3d cross = edge_a.cross(edge_b);
      if (cross.norm() < 1e-9) continue;
      const Vec3d n = cross.normalized();
      try_axis(best.edges, n);
      try_axis(best.edges, -n);
    }
  }
  return best;
}

}  // namespace cs550::test
