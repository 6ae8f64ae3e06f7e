#include "pages/base/cutaway.hpp"

#include <algorithm>

namespace cs550::pages {
namespace {

constexpr float glass = 0.10F;         ///< opacity of a ground that is in the way
constexpr Real too_many = Real(0.08);  ///< share of the other solids that may be hidden

bool hides(const Solid& ground, const Vec3& point, const Vec3& eye) {
  const Vec3 ray = point - eye;
  const Real length = ray.norm();
  const Real entered =
      entry_distance(*ground.mesh, ground.pose.to_body(eye), ground.pose.unrotate(ray / length));
  return entered < length;
}

}  // namespace

Real entry_distance(const HalfEdgeMesh& mesh, const Vec3& origin, const Vec3& direction) {
  Real enters = 0;
  Real leaves = HUGE_VALF;
  for (const Face& face : mesh.faces) {
    const Real speed = face.plane.normal.dot(direction);
    const Real distance = face.plane.distance(origin);
    if (speed < 0) enters = std::max(enters, -distance / speed);
    if (speed > 0) leaves = std::min(leaves, -distance / speed);
    if (speed == 0 && distance > 0) return HUGE_VALF;
  }
  return enters < leaves ? enters : HUGE_VALF;
}

void open_view(std::vector<Solid>& solids, const Vec3& eye) {
  std::vector<Vec3> points;
  for (const Solid& solid : solids) {
    if (!solid.is_ground) points.push_back(solid.pose.position);
  }
  for (Solid& solid : solids) {
    if (!solid.is_ground || !solid.mesh) continue;
    const auto hidden = std::count_if(points.begin(), points.end(),
                                      [&](const Vec3& point) { return hides(solid, point, eye); });
    if (static_cast<Real>(hidden) > too_many * static_cast<Real>(points.size())) {
      solid.colour.w() = glass;
    }
  }
}

}  // namespace cs550::pages
