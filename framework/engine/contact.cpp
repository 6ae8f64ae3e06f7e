/// @file contact.cpp
/// Warm starting: last step's impulses, carried over to this step's points.

#include "cs550/contact.hpp"

#include <algorithm>

namespace cs550 {
namespace {

const ContactPoint* find_feature(const Manifold& manifold, FeatureId feature) {
  for (const ContactPoint& point : manifold.points) {
    if (point.feature == feature) return &point;
  }
  return nullptr;
}

/// v of the frame (n, u, v).
Vec3 second_tangent(const Manifold& manifold) { return manifold.normal.cross(manifold.tangent); }

}  // namespace

void carry_impulses(const Manifold& before, Manifold& now) {
  const Real turned = before.normal.dot(now.normal);
  const Vec3 v_before = second_tangent(before);
  const Vec3 v_now = second_tangent(now);
  for (ContactPoint& point : now.points) {
    const ContactPoint* last = find_feature(before, point.feature);
    if (!last) continue;
    point.normal_impulse = std::max(Real(0), last->normal_impulse * turned);
    const Vec3 impulse =
        last->tangent_impulse.x() * before.tangent + last->tangent_impulse.y() * v_before;
    point.tangent_impulse = {impulse.dot(now.tangent), impulse.dot(v_now)};
  }
}

}  // namespace cs550
