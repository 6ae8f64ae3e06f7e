#include "engine/pairs/minkowski_difference.hpp"

#include <algorithm>

#include "cs550/hill_climbing.hpp"
#include "engine/pairs/relative_pose.hpp"

namespace cs550 {

namespace {

/// Whether the base contains the projection of the origin onto its plane.
bool is_above_origin(std::span<const Vec3> base, const Vec3& normal) {
  Vec3 from = base.back();
  for (const Vec3& to : base) {
    const Vec3 inward = normal.cross(to - from);
    if (inward.dot(from) > 0) return false;
    from = to;
  }
  return true;
}

}  // namespace

MinkowskiDifference::MinkowskiDifference(const PosedShape& other, Index of_other,
                                         const PosedShape& body, Index of_body)
    : other_(other.mesh()),
      body_(body.mesh()),
      other_in_body_(seen_from(body.pose, other.pose)),
      inner_radii_(other.shape->inner_radius + body.shape->inner_radius),
      of_other_(of_other),
      of_body_(of_body) {}

bool MinkowskiDifference::limits_separation(Real limit, std::span<const Vec3> base,
                                            const Vec3& normal) {
  const bool apart = normal.dot(base[0]) > 0;
  return apart ? is_above_origin(base, normal)
               : is_around_ball(std::max(Real(0), -limit), base, normal);
}

bool MinkowskiDifference::is_around_ball(Real radius, std::span<const Vec3> base,
                                         const Vec3& normal) {
  // About the difference of the two bodies' origins is a ball with the sum of their inner radii.
  const Vec3 apex = other_in_body_.position + inner_radii_ * normal;
  constexpr int replacements = 3;
  Vec3 from = base.back();
  for (const Vec3& to : base) {
    if (!is_beyond_ball(from, to, apex, radius, replacements)) return false;
    from = to;
  }
  return true;
}

/// Whether the ball is behind a side, a triangle counter-clockwise as seen from outside, or behind what
/// replaces that side.
bool MinkowskiDifference::is_beyond_ball(const Vec3& p, const Vec3& q, const Vec3& r, Real radius,
                                         int replacements) {
  const Vec3 outward = (q - p).cross(r - p);
  const Real scaled_radius = radius * outward.norm();
  if (outward.dot(p) >= scaled_radius) return true;
  if (replacements == 0) return false;

  const Vec3 far = farthest(outward);
  const bool separates_better = outward.dot(far) < scaled_radius;
  if (separates_better) return false;
  return is_beyond_ball(p, q, far, radius, replacements - 1) &&
         is_beyond_ball(q, r, far, radius, replacements - 1) &&
         is_beyond_ball(r, p, far, radius, replacements - 1);
}

Vec3 MinkowskiDifference::farthest(const Vec3& direction) {
  of_other_ = hill_climb(other_, other_in_body_.unrotate(direction), of_other_).vertex;
  of_body_ = hill_climb(body_, -direction, of_body_).vertex;
  return from_other(other_.vertex(of_other_)) - body_.vertex(of_body_);
}

}  // namespace cs550
