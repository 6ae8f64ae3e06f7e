#include "engine/contacts/solver_bodies.hpp"

namespace cs550 {

void SolverBody::apply(const Vec3& impulse, const Vec3& r) {
  v += inverse_mass * impulse;
  w += world_inverse_inertia * r.cross(impulse);
}

void gather(const RigidBody& body, SolverBody& solver_body) {
  solver_body.v = body.linear_velocity;
  solver_body.w = body.angular_velocity;
  solver_body.inverse_mass = body.inverse_mass;
  solver_body.world_inverse_inertia = body.world_inverse_inertia;
}

void gather_solver_bodies(WorldState& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    gather(world.bodies[i], world.solver_bodies[i]);
  }
}

void write_back_momenta(WorldState& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    RigidBody& body = world.bodies[i];
    if (body.kind != BodyKind::Dynamic) continue;
    const Vec3 dv = world.solver_bodies[i].v - body.linear_velocity;
    const Vec3 dw = world.solver_bodies[i].w - body.angular_velocity;
    if (dv.isZero(0) && dw.isZero(0)) continue;
    const Vec3 dw_body = body.pose.unrotate(dw);
    body.linear_momentum += body.mass * dv;
    body.angular_momentum += body.pose.rotate(body.inertia * dw_body);
    refresh_velocity(body);
  }
}

}  // namespace cs550
