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

void gather(std::span<const RigidBody> bodies, std::span<SolverBody> solver_bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) gather(bodies[i], solver_bodies[i]);
}

void gather_solver_bodies(WorldState& world) {
  for_solver_body_blocks(
      world, [](std::span<const RigidBody> bodies, std::span<SolverBody> solver_bodies) {
        gather(bodies, solver_bodies);
      });
}

void write_back_solver_bodies(WorldState& world) {
  for_solver_body_blocks(world, add_momentum_changes);
}

}  // namespace cs550
