/// @file body_sweeps.cpp
/// Lab 1 for the engine: the sweeps of a substep over all bodies, with the bits that the functions of
/// the lab leave.
///
/// Momenta change without a turn, so world_inverse_inertia stays as it is: refresh_velocity() would
/// derive the same one again. Bodies turn independently of each other: eight of them are turned at a
/// time, one in each lane.

#include "engine/body_sweeps.hpp"

#include "sweeps_in_lanes.hpp"

namespace cs550 {

void integrate_momenta(std::span<RigidBody> bodies, Real h) {
  for (RigidBody& body : bodies) {
    if (body.kind != BodyKind::Dynamic || body.asleep) continue;
    body.linear_momentum += h * body.force;
    body.angular_momentum += h * body.torque;
    body.linear_velocity = body.inverse_mass * body.linear_momentum;
    body.angular_velocity = body.world_inverse_inertia * body.angular_momentum;
  }
}

void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies) {
#if CS550_HAS_AVX2_FORMS
  if (has_avx2()) return lanes_of_eight::add_momentum_changes(bodies, solver_bodies);
#endif
  lanes_of_four::add_momentum_changes(bodies, solver_bodies);
}

void integrate_poses(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h,
                     RotationMethod method) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    const bool turned_below =
        body.kind == BodyKind::Dynamic && method == RotationMethod::ImplicitMidpoint;
    if (body.kind == BodyKind::Static || body.asleep || turned_below) continue;
    solver_bodies[i].delta_position += h * body.linear_velocity;
    solver_bodies[i].delta_rotation += h * body.angular_velocity;
    turn_and_move(body, h, method);
  }
  if (method != RotationMethod::ImplicitMidpoint) return;
#if CS550_HAS_AVX2_FORMS
  if (has_avx2()) return lanes_of_eight::turn_dynamic_bodies(bodies, solver_bodies, h);
#endif
  lanes_of_four::turn_dynamic_bodies(bodies, solver_bodies, h);
}

}  // namespace cs550
