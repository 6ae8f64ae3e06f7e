#pragma once
/// @file wide_momenta.hpp
/// The change of eight bodies' momenta by contacts, each lane with the bits of the teaching form.

#include "engine/body_sweeps.hpp"
#include "engine/wide_structs.hpp"

namespace cs550::CS550_LANES {

inline WideVec3 select(WideMask mask, const WideVec3& a, const WideVec3& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

inline WideMask equal(const WideVec3& a, const WideVec3& b) {
  return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
}

/// The velocities of a solver body.
struct WideVelocities {
  WideVec3 v, w;

  explicit WideVelocities(const PerLane<const SolverBody>& bodies)
      : WideVelocities(WideReals<SolverBody, 6>(bodies, &SolverBody::v)) {}

 private:
  explicit WideVelocities(const WideReals<SolverBody, 6>& body)
      : v(body(&SolverBody::v)), w(body(&SolverBody::w)) {}
};

struct WideMomenta {
  WideReal mass, inverse_mass;
  WideMat3 inertia;
  WideQuat orientation;
  WideVec3 linear_momentum, angular_momentum, force;
  WideVec3 linear_velocity, angular_velocity;
  WideMat3 world_inverse_inertia;

  explicit WideMomenta(const PerLane<RigidBody>& bodies)
      : WideMomenta(Reals(bodies, &RigidBody::mass)) {}

  /// Adds the momenta that belong to the changed velocities. @returns whether any velocity changed
  bool add_change(const PerLane<const SolverBody>& solver_bodies) {
    const WideVelocities now(solver_bodies);
    const WideMask changes = ~(equal(now.v, linear_velocity) & equal(now.w, angular_velocity));
    if (!any(changes)) return false;
    const WideVec3 dw_body = orientation.conjugate() * (now.w - angular_velocity);
    const WideVec3 dp = mass * (now.v - linear_velocity);
    const WideVec3 dl = orientation * (inertia * dw_body);
    linear_momentum = select(changes, linear_momentum + dp, linear_momentum);
    angular_momentum = select(changes, angular_momentum + dl, angular_momentum);
    linear_velocity = inverse_mass * linear_momentum;
    angular_velocity = world_inverse_inertia * angular_momentum;
    return true;
  }

  /// Momenta and velocities, in blocks of four Reals.
  void store(const PerLane<RigidBody>& bodies) const {
    const auto& p = linear_momentum;
    const auto& l = angular_momentum;
    const auto& v = linear_velocity;
    const auto& w = angular_velocity;
    const WideVec3& column = world_inverse_inertia.column[0];
    const auto at_p = [](RigidBody& body) { return body.linear_momentum.data(); };
    const auto in_l = [](RigidBody& body) { return body.angular_momentum.data() + 1; };
    const auto at_v = [](RigidBody& body) { return body.linear_velocity.data(); };
    const auto in_w = [](RigidBody& body) { return body.angular_velocity.data() + 1; };
    FourReals{p.x, p.y, p.z, l.x}.store(bodies, at_p);
    FourReals{l.y, l.z, force.x, force.y}.store(bodies, in_l);
    FourReals{v.x, v.y, v.z, w.x}.store(bodies, at_v);
    FourReals{w.y, w.z, column.x, column.y}.store(bodies, in_w);
  }

 private:
  using Reals =
      WideReals<RigidBody, (sizeof(RigidBody) - offsetof(RigidBody, mass)) / sizeof(Real)>;

  explicit WideMomenta(const Reals& body)
      : mass(body(&RigidBody::mass)),
        inverse_mass(body(&RigidBody::inverse_mass)),
        inertia(body(&RigidBody::inertia)),
        orientation(body(&RigidBody::pose, &Pose::orientation)),
        linear_momentum(body(&RigidBody::linear_momentum)),
        angular_momentum(body(&RigidBody::angular_momentum)),
        force(body(&RigidBody::force)),
        linear_velocity(body(&RigidBody::linear_velocity)),
        angular_velocity(body(&RigidBody::angular_velocity)),
        world_inverse_inertia(body(&RigidBody::world_inverse_inertia)) {}
};

}  // namespace cs550::CS550_LANES
