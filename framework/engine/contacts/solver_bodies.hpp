#pragma once
/// @file solver_bodies.hpp
/// SolverBody[], the copy of the bodies that contact solvers work on.

#include <span>

#include "engine/body_sweeps.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Copies mass, inertia and velocities of bodies. Their displacements are kept. Whatever changes velocities
/// outside a solver copies them again, so that the array is always that of the bodies.
/// @{
void gather(const RigidBody& body, SolverBody& solver_body);
void gather(std::span<const RigidBody> bodies, std::span<SolverBody> solver_bodies);
void gather_solver_bodies(WorldState& world);
/// @}

/// add_momentum_changes() for all bodies.
void write_back_solver_bodies(WorldState& world);

/// Runs `solve(bodies)` on SolverBody[] and writes it back. Only threads that solve a part each do so themselves. Without
/// constraints there is nothing to solve. @pre the array is that of the bodies
template <class Solve>
void with_solver_bodies(WorldState& world, const Solve& solve) {
  if (world.constraints.empty()) return;
  solve(std::span<SolverBody>(world.solver_bodies));
  write_back_solver_bodies(world);
}

}  // namespace cs550
