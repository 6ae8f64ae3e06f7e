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
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) gather(world.bodies[i], world.solver_bodies[i]);
  });
}

void write_back_solver_bodies(WorldState& world) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    add_momentum_changes(std::span(world.bodies).subspan(first, last - first),
                         std::span(world.solver_bodies).subspan(first, last - first));
  });
}

}  // namespace cs550
