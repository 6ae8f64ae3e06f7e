#include <algorithm>
#include <stdexcept>

#include "engine/world_state.hpp"

namespace cs550 {

namespace {

/// Clips a ray by the planes of a convex body (Cyrus & Beck 1978). The ray hits the face whose plane
/// it enters last, unless it leaves through another plane before.
std::optional<RayHit> ray_against(const PosedShape& body, const Vec3& origin, const Vec3& direction,
                                  Real length) {
  const Vec3 local_origin = body.pose.to_body(origin);
  const Vec3 local_direction = body.pose.unrotate(direction);
  Real enter = -1;
  Real leave = length;
  Index entered = no_index;
  for (Index f = 0; f < body.mesh().face_count(); ++f) {
    const Plane& plane = body.mesh().face(f).plane;
    const Real distance = plane.distance(local_origin);
    const Real approach = -plane.normal.dot(local_direction);
    if (approach <= 0 && distance > 0) return std::nullopt;
    if (approach == 0) continue;
    const Real t = distance / approach;
    if (approach > 0 && t > enter) {
      enter = t;
      entered = f;
    } else if (approach < 0) {
      leave = std::min(leave, t);
    }
  }
  if (entered == no_index || enter < 0 || enter > leave) return std::nullopt;
  RayHit hit;
  hit.face = entered;
  hit.distance = enter;
  hit.point = origin + enter * direction;
  hit.normal = body.pose.rotate(body.mesh().face(entered).plane.normal);
  return hit;
}

}  // namespace

std::optional<RayHit> World::ray_cast(const Vec3& origin, const Vec3& direction,
                                      Real length) const {
  const bool is_ray =
      origin.allFinite() && direction.allFinite() && !direction.isZero(0) && length >= 0;
  if (!is_ray) {
    throw std::invalid_argument(
        "World::ray_cast() needs a finite origin, a finite direction that is not zero, and a "
        "length of 0 or more");
  }
  // Its square may be outside the range of Real, but not outside that of double.
  const Vec3 unit = direction.cast<double>().normalized().cast<Real>();
  std::optional<RayHit> nearest;
  state_->tree.ray_cast(origin, unit, length, [&](Index body, Real reach) {
    const auto hit = ray_against(state_->posed_shape(body), origin, unit, reach);
    if (!hit) return reach;
    nearest = hit;
    nearest->body = state_->id_at(body);
    return hit->distance;
  });
  return nearest;
}

std::vector<BodyId> World::query(const Bounds& bounds) const {
  const bool contains_nothing = bounds.lower == Bounds().lower && bounds.upper == Bounds().upper;
  if (contains_nothing) return {};
  if (!(bounds.lower.array() <= bounds.upper.array()).all()) {
    throw std::invalid_argument(
        "World::query() needs bounds whose lower corner is nowhere above the upper one");
  }
  std::vector<Index> near;
  state_->tree.query(bounds, near);
  std::sort(near.begin(), near.end());
  std::vector<BodyId> found;
  for (const Index body : near) {
    if (world_bounds(state_->posed_shape(body)).overlaps(bounds)) found.push_back(id_at(body));
  }
  return found;
}

}  // namespace cs550
