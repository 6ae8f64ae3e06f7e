#pragma once
/// @file contact_values.hpp
/// Arguments for labs 6 and 7: two moving bodies and contacts between them.

#include <vector>

#include "cs550/contact_constraint.hpp"
#include "helpers/random.hpp"

namespace cs550::test {

inline SolverBody moving(Random& random) {
  SolverBody body;
  body.v = random.point_in_box({3, 3, 3});
  body.w = random.point_in_box({3, 3, 3});
  body.inverse_mass = random.real(0.5F, 2);
  body.world_inverse_inertia = Vec3(2, 3, 4).asDiagonal();
  body.delta_position = random.point_in_box({0.01F, 0.01F, 0.01F});
  body.delta_rotation = random.point_in_box({0.01F, 0.01F, 0.01F});
  return body;
}

/// A contact that approaches, overlaps, slides and has accumulated impulses.
inline ContactConstraint touching(Random& random) {
  ContactConstraint constraint;
  constraint.body_a = 0;
  constraint.body_b = 1;
  constraint.n = random.unit_vector();
  constraint.u = any_perpendicular(constraint.n);
  constraint.r_a = random.point_in_box({1, 1, 1});
  constraint.r_b = random.point_in_box({1, 1, 1});
  constraint.separation = -0.1F;
  constraint.friction = 0.4F;
  constraint.restitution = 0.5F;
  constraint.normal_mass = 0.7F;
  constraint.tangent_mass << 0.6F, 0.1F, 0.1F, 0.5F;
  constraint.softness = {10, 0.9F, 0.1F};
  constraint.approach_velocity = -2;
  constraint.normal_impulse = 1;
  constraint.tangent_impulse = {0.2F, 0.1F};
  return constraint;
}

struct BodiesInContact {
  Random random{32};
  std::vector<SolverBody> bodies = {moving(random), moving(random)};
  std::vector<ContactConstraint> constraints = {touching(random), touching(random),
                                                touching(random)};
};

}  // namespace cs550::test
