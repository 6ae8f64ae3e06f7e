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
/// add_momentum_changes() for all bodies.
void write_back_solver_bodies(WorldState& world);

/// Runs `solve(bodies)` on SolverBody[] between gathering and writing back. Nothing else writes the array
/// back. Without constraints there is nothing to solve.
template <class Solve>
void with_solver_bodies(WorldState& world, const Solve& solve) {
  if (world.constraints.empty()) return;
  gather_solver_bodies(world);
  solve(std::span<SolverBody>(world.solver_bodies));
  write_back_solver_bodies(world);
}

}  // namespace cs550
