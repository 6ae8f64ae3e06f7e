#pragma once
/// @file wide_turn.hpp
/// L1.7 and L1.3 for eight bodies at a time, each lane with the bits of the teaching form.

#include "wide_momenta.hpp"

namespace cs550::CS550_LANES {

/// What a turn needs of eight dynamic bodies, and the Reals beside what it changes.
struct WideTurn {
  WideMat3 inverse_inertia;
  WideVec3 position;
  WideQuat orientation;
  WideVec3 linear_momentum, angular_momentum;
  WideVec3 linear_velocity, angular_velocity;

  explicit WideTurn(const PerLane<RigidBody>& bodies)
      : WideTurn(Reals(bodies, &RigidBody::inverse_inertia)) {}

 private:
  using Reals = WideReals<RigidBody, (offsetof(RigidBody, angular_velocity) -
                                      offsetof(RigidBody, inverse_inertia) + sizeof(Vec3)) /
                                         sizeof(Real)>;

  explicit WideTurn(const Reals& body)
      : inverse_inertia(body(&RigidBody::inverse_inertia)),
        position(body(&RigidBody::pose, &Pose::position)),
        orientation(body(&RigidBody::pose, &Pose::orientation)),
        linear_momentum(body(&RigidBody::linear_momentum)),
        angular_momentum(body(&RigidBody::angular_momentum)),
        linear_velocity(body(&RigidBody::linear_velocity)),
        angular_velocity(body(&RigidBody::angular_velocity)) {}
};

/// What a turn changes.
struct WideTurned {
  WideVec3 position;
  WideQuat orientation;
  WideMat3 world_inverse_inertia;
  WideVec3 angular_velocity;
};

/// rotation_exp().
inline WideQuat rotation_exp(const WideVec3& v) {
  const WideReal square = all_lanes(Real(0.25)) * v.dot(v);
  const auto term = [](int divisor) { return all_lanes(Real(1) / static_cast<Real>(divisor)); };
  WideReal sinc = all_lanes(1) - square * (term(6) - square * (term(120) - square * term(5040)));
  WideReal cosine =
      all_lanes(1) -
      square * (term(2) - square * (term(24) - square * (term(720) - square * term(40320))));
  const WideMask large = ~(square < all_lanes(Real(0.25)));
  if (any(large)) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if (!large[lane]) continue;
      const Real half_angle = std::sqrt(square[lane]);
      sinc.set(lane, sine(half_angle) / half_angle);
      cosine.set(lane, cs550::cosine(half_angle));
    }
  }
  return {(all_lanes(Real(0.5)) * sinc) * v, cosine};
}

/// L1.7: w = ω(exp(½·h·w)·q).
inline WideVec3 midpoint_angular_velocity(const WideTurn& body, Real h) {
  constexpr int iterations = 3;
  WideVec3 w = body.angular_velocity;
  WideMask done = WideMask{};
  for (int i = 0; i < iterations && !all(done); ++i) {
    const WideQuat q = rotation_exp(all_lanes(Real(0.5) * h) * w) * body.orientation;
    const WideVec3 next = q * (body.inverse_inertia * (q.conjugate() * body.angular_momentum));
    const WideMask fixed = equal(next, w);
    w = select(done, w, next);
    done = done | fixed;
  }
  return w;
}

/// integrate_pose() and refresh_velocity().
inline WideTurned turned(const WideTurn& body, Real h) {
  const WideVec3 w = midpoint_angular_velocity(body, h);
  WideTurned after;
  after.position = body.position + all_lanes(h) * body.linear_velocity;
  after.orientation = (rotation_exp(all_lanes(h) * w) * body.orientation).normalized();
  const WideMat3 rotation = after.orientation.rotation();
  after.world_inverse_inertia = rotation * body.inverse_inertia * rotation.transpose();
  after.angular_velocity = after.world_inverse_inertia * body.angular_momentum;
  return after;
}

inline WideReal turning_energy(const WideTurn& body, const WideVec3& angular_velocity) {
  return all_lanes(Real(0.5)) * angular_velocity.dot(body.angular_momentum);
}

/// What turn_and_move() asks of a turn.
inline WideMask keeps_energy(const WideTurn& before, const WideTurned& after) {
  const WideReal energy = turning_energy(before, before.angular_velocity);
  const WideReal change = turning_energy(before, after.angular_velocity) - energy;
  const WideReal most = all_lanes(allowed_change) * energy;
  return (change <= most) & (-change <= most);
}

/// Pose, and angular velocity with the inertia that follows it: blocks of four Reals.
inline void store(const WideTurn& before, const WideTurned& after,
                  const PerLane<RigidBody>& bodies) {
  const auto at_position = [](RigidBody& body) { return body.pose.position.data(); };
  const auto after_position = [](RigidBody& body) { return body.pose.position.data() + 4; };
  const WideVec3& x = after.position;
  const WideQuat& q = after.orientation;
  FourReals{x.x, x.y, x.z, q.vec.x}.store(bodies, at_position);
  FourReals{q.vec.y, q.vec.z, q.w, before.linear_momentum.x}.store(bodies, after_position);
  const auto& [c0, c1, c2] = after.world_inverse_inertia.column;
  const WideVec3& w = after.angular_velocity;
  const auto at_velocity = [](RigidBody& body) { return body.angular_velocity.data(); };
  const auto in_inertia = [](RigidBody& body) { return body.angular_velocity.data() + 4; };
  const auto at_end = [](RigidBody& body) { return body.angular_velocity.data() + 8; };
  FourReals{w.x, w.y, w.z, c0.x}.store(bodies, at_velocity);
  FourReals{c0.y, c0.z, c1.x, c1.y}.store(bodies, in_inertia);
  FourReals{c1.z, c2.x, c2.y, c2.z}.store(bodies, at_end);
}

/// Adds what the bodies move to the displacements of their solver bodies.
inline void count_displacements(const WideTurn& body, Real h,
                                const PerLane<SolverBody>& solver_bodies) {
  const auto at_position = [](auto& solver_body) { return solver_body.delta_position.data(); };
  const auto at_end = [](auto& solver_body) { return solver_body.delta_position.data() + 2; };
  FourReals first = FourReals::load(solver_bodies, at_position);
  FourReals last = FourReals::load(solver_bodies, at_end);
  const WideVec3 moved = all_lanes(h) * body.linear_velocity;
  const WideVec3 turned = all_lanes(h) * body.angular_velocity;
  first.first = first.first + moved.x;
  first.second = first.second + moved.y;
  first.third = last.first = first.third + moved.z;
  first.fourth = last.second = first.fourth + turned.x;
  last.third = last.third + turned.y;
  last.fourth = last.fourth + turned.z;
  first.store(solver_bodies, at_position);
  last.store(solver_bodies, at_end);
}

}  // namespace cs550::CS550_LANES
