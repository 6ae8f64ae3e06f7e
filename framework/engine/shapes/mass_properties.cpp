#include "cs550/mass_properties.hpp"

namespace cs550 {
namespace {

using Vec3d = Eigen::Vector3d;
using Mat3d = Eigen::Matrix3d;

/// ∫ 1, ∫ x and ∫ x·xᵀ over a solid, gathered from signed tetrahedra between the origin and the
/// triangles of its surface: what lies outside the solid is counted once with each sign.
struct Moments {
  double volume = 0;
  Vec3d first = Vec3d::Zero();
  Mat3d second = Mat3d::Zero();

  void add_tetrahedron(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double six_volumes = a.dot(b.cross(c));
    const Vec3d sum = a + b + c;
    volume += six_volumes / 6;
    first += six_volumes / 24 * sum;
    second += six_volumes / 120 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
};

Moments moments_about(const Vec3d& origin, const HalfEdgeMesh& mesh) {
  const auto corner = [&](Index v) -> Vec3d { return mesh.vertex(v).cast<double>() - origin; };
  Moments moments;
  for (const Face& face : mesh.faces) {
    const Index apex = mesh.origin(face.edge);
    const Index last = mesh.edge(face.edge).prev;
    for (Index e = mesh.edge(face.edge).next; e != last; e = mesh.edge(e).next) {
      moments.add_tetrahedron(corner(apex), corner(mesh.origin(e)), corner(mesh.edge(e).vertex));
    }
  }
  return moments;
}

}  // namespace

MassProperties mass_properties(const HalfEdgeMesh& mesh) {
  // A point of the mesh as the origin: far from the world's, the moments would cancel badly.
  const Vec3d origin = mesh.vertex(0).cast<double>();
  const Moments moments = moments_about(origin, mesh);

  const Vec3d centroid = moments.first / moments.volume;
  const Mat3d second = moments.second - moments.volume * centroid * centroid.transpose();
  const Mat3d inertia = second.trace() * Mat3d::Identity() - second;
  return {static_cast<Real>(moments.volume), (origin + centroid).cast<Real>(),
          inertia.cast<Real>()};
}

}  // namespace cs550
