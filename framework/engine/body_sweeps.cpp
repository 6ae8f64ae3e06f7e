#include "engine/body_sweeps.hpp"

namespace cs550 {

[[gnu::weak]] void integrate_momenta(std::span<RigidBody> bodies, Real h) {
  for (RigidBody& body : bodies) {
    if (body.kind != BodyKind::Dynamic || body.asleep) continue;
    integrate_momentum(body, h);
    refresh_velocity(body);
  }
}

[[gnu::weak]] void add_momentum_changes(std::span<RigidBody> bodies,
                                        std::span<const SolverBody> solver_bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    if (body.kind != BodyKind::Dynamic || body.asleep) continue;
    const Vec3 dv = solver_bodies[i].v - body.linear_velocity;
    const Vec3 dw = solver_bodies[i].w - body.angular_velocity;
    if (dv.isZero(0) && dw.isZero(0)) continue;
    const Vec3 dw_body = body.pose.unrotate(dw);
    body.linear_momentum += body.mass * dv;
    body.angular_momentum += body.pose.rotate(body.inertia * dw_body);
    refresh_velocity(body);
  }
}

/// Separations change by what the bodies move in this substep: displacements are counted first.
[[gnu::weak]] void integrate_poses(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies,
                                   Real h, RotationMethod method) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    RigidBody& body = bodies[i];
    if (body.kind == BodyKind::Static || body.asleep) continue;
    solver_bodies[i].delta_position += h * body.linear_velocity;
    solver_bodies[i].delta_rotation += h * body.angular_velocity;
    turn_and_move(body, h, method);
  }
}

}  // namespace cs550
