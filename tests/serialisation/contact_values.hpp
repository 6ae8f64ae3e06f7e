#pragma once
/// @file contact_values.hpp
/// What labs 6 and 7 are called with: two bodies that move, and contacts between them.

#include <vector>

#include "cs550/contact_row.hpp"
#include "support/random.hpp"

namespace cs550::test {

inline BodyVelocity moving(Random& random) {
  BodyVelocity body;
  body.v = random.point_in_box({3, 3, 3});
  body.w = random.point_in_box({3, 3, 3});
  body.inverse_mass = random.real(0.5F, 2);
  body.world_inverse_inertia = Vec3(2, 3, 4).asDiagonal();
  body.delta_position = random.point_in_box({0.01F, 0.01F, 0.01F});
  body.delta_rotation = random.point_in_box({0.01F, 0.01F, 0.01F});
  return body;
}

/// A contact that approaches, overlaps, slides and has impulses from before.
inline ContactRow touching(Random& random) {
  ContactRow row;
  row.body_a = 0;
  row.body_b = 1;
  row.n = random.unit_vector();
  row.u = any_perpendicular(row.n);
  row.r_a = random.point_in_box({1, 1, 1});
  row.r_b = random.point_in_box({1, 1, 1});
  row.separation = -0.1F;
  row.friction = 0.4F;
  row.restitution = 0.5F;
  row.normal_mass = 0.7F;
  row.tangent_mass << 0.6F, 0.1F, 0.1F, 0.5F;
  row.softness = {10, 0.9F, 0.1F};
  row.approach_velocity = -2;
  row.normal_impulse = 1;
  row.tangent_impulse = {0.2F, 0.1F};
  return row;
}

struct BodiesInContact {
  Random random{32};
  std::vector<BodyVelocity> bodies = {moving(random), moving(random)};
  std::vector<ContactRow> rows = {touching(random), touching(random), touching(random)};
};

}  // namespace cs550::test
