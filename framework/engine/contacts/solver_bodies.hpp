#pragma once
/// @file solver_bodies.hpp
/// SolverBody[], the copy of the bodies that contact solvers work on.

#include <span>

#include "engine/body_sweeps.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Copies mass, inertia and velocities of a body. The displacement is kept.
void gather(const RigidBody& body, SolverBody& solver_body);
/// Does so for all bodies.
void gather_solver_bodies(WorldState& world);

/// Calls `visit(bodies, solver_bodies)` for blocks that make up all bodies, by several threads if there
/// are any.
template <class Visit>
void for_body_blocks(WorldState& world, const Visit& visit) {
  constexpr std::size_t block = 64;
  for_blocks(world.team, world.bodies.size(), block, [&](std::size_t first, std::size_t last) {
    visit(std::span(world.bodies).subspan(first, last - first),
          std::span(world.solver_bodies).subspan(first, last - first));
  });
}

/// Runs `solve(bodies)` on SolverBody[] between gathering and writing back. Nothing else gathers or
/// writes back the array. Without constraints there is nothing to solve.
template <class Solve>
void with_solver_bodies(WorldState& world, const Solve& solve) {
  if (world.constraints.empty()) return;
  gather_solver_bodies(world);
  solve(std::span<SolverBody>(world.solver_bodies));
  for_body_blocks(world, [](std::span<RigidBody> bodies, std::span<const SolverBody> solved) {
    add_momentum_changes(bodies, solved);
  });
}

}  // namespace cs550
