#pragma once
/// @file batch.hpp
/// Up to four constraints and their bodies, one in each lane: read from the arrays, solved, written
/// back.

#include <cstddef>

#include "cs550/contact_constraint.hpp"
#include "engine/wide_structs.hpp"

namespace cs550 {

struct WideBody {
  WideVec3 v, w;
  WideReal inverse_mass;
  WideMat3 inverse_inertia;
  WideVec3 delta_position, delta_rotation;

  explicit WideBody(const PerLane<SolverBody>& bodies)
      : WideBody(AllReals(bodies, &SolverBody::v)) {}

  void store_velocities(const PerLane<SolverBody>& bodies) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      bodies[lane]->v = {v.x[lane], v.y[lane], v.z[lane]};
      bodies[lane]->w = {w.x[lane], w.y[lane], w.z[lane]};
    }
  }

  /// SolverBody::apply().
  void apply(const WideVec3& impulse, const WideVec3& r) {
    v = v + inverse_mass * impulse;
    w = w + inverse_inertia * r.cross(impulse);
  }

 private:
  using AllReals = WideReals<SolverBody, sizeof(SolverBody) / sizeof(Real)>;

  explicit WideBody(const AllReals& body)
      : v(body(&SolverBody::v)),
        w(body(&SolverBody::w)),
        inverse_mass(body(&SolverBody::inverse_mass)),
        inverse_inertia(body(&SolverBody::world_inverse_inertia)),
        delta_position(body(&SolverBody::delta_position)),
        delta_rotation(body(&SolverBody::delta_rotation)) {}
};

struct WideConstraint {
  using C = ContactConstraint;

  WideVec3 n, u, r_a, r_b;
  WideReal separation, friction, restitution, normal_mass;
  WideMat2 tangent_mass;
  WideReal bias_rate, mass_scale, impulse_scale, approach_velocity;
  WideReal normal_impulse, tangent_u, tangent_v;

  explicit WideConstraint(const PerLane<C>& constraints)
      : WideConstraint(Constants(constraints, &C::n), constraints) {}

  void store_impulses(const PerLane<C>& constraints) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      constraints[lane]->normal_impulse = normal_impulse[lane];
      constraints[lane]->tangent_impulse = {tangent_u[lane], tangent_v[lane]};
    }
  }

 private:
  /// The Reals from n to approach_velocity: what a pass does not change.
  using Constants =
      WideReals<C, (offsetof(C, approach_velocity) - offsetof(C, n)) / sizeof(Real) + 1>;

  WideConstraint(const Constants& constraint, const PerLane<C>& constraints)
      : n(constraint(&C::n)),
        u(constraint(&C::u)),
        r_a(constraint(&C::r_a)),
        r_b(constraint(&C::r_b)),
        separation(constraint(&C::separation)),
        friction(constraint(&C::friction)),
        restitution(constraint(&C::restitution)),
        normal_mass(constraint(&C::normal_mass)),
        tangent_mass(constraint(&C::tangent_mass)),
        bias_rate(constraint(&C::softness, &Softness::bias_rate)),
        mass_scale(constraint(&C::softness, &Softness::mass_scale)),
        impulse_scale(constraint(&C::softness, &Softness::impulse_scale)),
        approach_velocity(constraint(&C::approach_velocity)),
        normal_impulse(gather(constraints, &C::normal_impulse)),
        tangent_u(gather(constraints, &C::tangent_impulse, 0)),
        tangent_v(gather(constraints, &C::tangent_impulse, 1)) {}
};

}  // namespace cs550
