/// @file body_sweeps.cpp
/// Lab 1 for the engine: the sweeps of a substep over all bodies, with the bits that the functions of
/// the lab leave.
///
/// Momenta change without a turn, so world_inverse_inertia stays as it is: refresh_velocity() would
/// derive the same one again. Turns are the expensive part, and bodies turn independently of each
/// other: four of them are turned at a time, one in each lane.

#include "engine/body_sweeps.hpp"

#include "engine/wide_structs.hpp"

namespace cs550 {

namespace {

/// refresh_velocity() of a dynamic body that has not turned.
void refresh_unturned(RigidBody& body) {
  body.linear_velocity = body.inverse_mass * body.linear_momentum;
  body.angular_velocity = body.world_inverse_inertia * body.angular_momentum;
}

/// What a turn needs of four dynamic bodies.
struct WideTurn {
  WideMat3 inverse_inertia;
  WideVec3 position;
  WideQuat orientation;
  WideVec3 angular_momentum, linear_velocity, angular_velocity;

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
        angular_momentum(body(&RigidBody::angular_momentum)),
        linear_velocity(body(&RigidBody::linear_velocity)),
        angular_velocity(body(&RigidBody::angular_velocity)) {}
};

/// What a turn changes.
struct WideTurned {
  WideQuat orientation;
  WideMat3 world_inverse_inertia;
  WideVec3 angular_velocity;
};

/// cos(x) for 0 ≤ x ≤ 1e-3: its series in double precision, rounded once. The first term left out
/// is 1e-21.
WideReal cosine_of_small(WideReal x) {
  WideReal cosine;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const double square = static_cast<double>(x[lane]) * static_cast<double>(x[lane]);
    cosine[lane] = static_cast<Real>(1 - square * (0.5 - square / 24));
  }
  return cosine;
}

/// rotation_exp().
WideQuat rotation_exp(const WideVec3& v) {
  const WideReal half_angle = all_lanes(Real(0.5)) * square_root(v.dot(v));
  WideReal sinc = all_lanes(1) - half_angle * half_angle / all_lanes(6);
  WideReal cosine;
  const WideMask large = half_angle > all_lanes(Real(1e-3));
  if (any(large)) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if (large[lane] != 0) sinc[lane] = sine(half_angle[lane]) / half_angle[lane];
      cosine[lane] = cs550::cosine(half_angle[lane]);
    }
  } else {
    cosine = cosine_of_small(half_angle);
  }
  return {(all_lanes(Real(0.5)) * sinc) * v, cosine};
}

WideVec3 select(WideMask mask, const WideVec3& a, const WideVec3& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

WideMask equal(const WideVec3& a, const WideVec3& b) {
  return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
}

/// L1.7: w = ω(exp(½·h·w)·q).
WideVec3 midpoint_angular_velocity(const WideTurn& body, Real h) {
  constexpr int iterations = 3;
  WideVec3 w = body.angular_velocity;
  WideMask done = WideMask{};
  for (int i = 0; i < iterations && !all(done); ++i) {
    const WideQuat q = rotation_exp(all_lanes(Real(0.5) * h) * w) * body.orientation;
    const WideVec3 next = q * (body.inverse_inertia * (q.conjugate() * body.angular_momentum));
    const WideMask fixed = equal(next, w);
    w = select(done, w, next);
    done |= fixed;
  }
  return w;
}

/// integrate_pose() and refresh_velocity().
WideTurned turned(const WideTurn& body, Real h) {
  const WideVec3 w = midpoint_angular_velocity(body, h);
  WideTurned after;
  after.orientation = (rotation_exp(all_lanes(h) * w) * body.orientation).normalized();
  const WideMat3 rotation = after.orientation.rotation();
  after.world_inverse_inertia = rotation * body.inverse_inertia * rotation.transpose();
  after.angular_velocity = after.world_inverse_inertia * body.angular_momentum;
  return after;
}

WideReal turning_energy(const WideTurn& body, const WideVec3& angular_velocity) {
  return all_lanes(Real(0.5)) * angular_velocity.dot(body.angular_momentum);
}

void store(const WideTurned& after, std::size_t lane, RigidBody& body) {
  const auto lane_of = [&](const WideVec3& v) { return Vec3(v.x[lane], v.y[lane], v.z[lane]); };
  body.pose.orientation.vec() = lane_of(after.orientation.vec);
  body.pose.orientation.w() = after.orientation.w[lane];
  for (int i = 0; i < 3; ++i) {
    body.world_inverse_inertia.col(i) = lane_of(after.world_inverse_inertia.column[i]);
  }
  body.angular_velocity = lane_of(after.angular_velocity);
}

/// turn_and_move() for up to four dynamic bodies.
void turn_and_move(const PerLane<RigidBody>& bodies, std::size_t count, Real h) {
  const WideTurn before(bodies);
  const WideTurned after = turned(before, h);
  const WideMask keeps_energy =
      turning_energy(before, after.angular_velocity) <=
      all_lanes(allowed_gain) * turning_energy(before, before.angular_velocity);
  for (std::size_t lane = 0; lane < count; ++lane) {
    RigidBody& body = *bodies[lane];
    if (keeps_energy[lane] != 0) {
      body.pose.position += h * body.linear_velocity;
      store(after, lane, body);
    } else {
      turn_and_move(body, h, RotationMethod::ImplicitMidpoint);
    }
  }
}

void count_displacement(const RigidBody& body, SolverBody& solver_body, Real h) {
  solver_body.delta_position += h * body.linear_velocity;
  solver_body.delta_rotation += h * body.angular_velocity;
}

}  // namespace

void integrate_momenta(std::span<RigidBody> bodies, Real h) {
  for (RigidBody& body : bodies) {
    if (body.kind != BodyKind::Dynamic || body.asleep) continue;
    body.linear_momentum += h * body.force;
    body.angular_momentum += h * body.torque;
    refresh_unturned(body);
  }
}

void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    if (body.kind != BodyKind::Dynamic || body.asleep) continue;
    const Vec3 dv = solver_bodies[i].v - body.linear_velocity;
    const Vec3 dw = solver_bodies[i].w - body.angular_velocity;
    if (dv.isZero(0) && dw.isZero(0)) continue;
    const Vec3 dw_body = body.pose.unrotate(dw);
    body.linear_momentum += body.mass * dv;
    body.angular_momentum += body.pose.rotate(body.inertia * dw_body);
    refresh_unturned(body);
  }
}

void integrate_poses(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h,
                     RotationMethod method) {
  RigidBody idle;
  PerLane<RigidBody> lanes;
  std::size_t count = 0;
  const auto turn_collected = [&] {
    for (std::size_t lane = count; lane < lane_count; ++lane) lanes[lane] = &idle;
    turn_and_move(lanes, count, h);
    count = 0;
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    if (body.kind == BodyKind::Static || body.asleep) continue;
    count_displacement(body, solver_bodies[i], h);
    if (body.kind == BodyKind::Dynamic && method == RotationMethod::ImplicitMidpoint) {
      lanes[count++] = &body;
      if (count == lane_count) turn_collected();
    } else {
      turn_and_move(body, h, method);
    }
  }
  if (count > 0) turn_collected();
}

}  // namespace cs550
