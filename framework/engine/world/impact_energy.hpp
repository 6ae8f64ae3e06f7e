#pragma once
/// @file impact_energy.hpp
/// Impacts give no energy. The calls are in the order of a substep with soft contacts that may bounce.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Notes the kinetic energy of every body. Call it after the forces and before the contacts of a substep.
void note_energy_before_impacts(WorldState& world);
/// Notes velocities and impulses. Call it after the bodies have moved, before the relax passes.
void begin_impacts(WorldState& world, std::span<const SolverBody> bodies);
/// Looks at each group of bodies that are connected by contacts. If the impulses since begin_impacts() have
/// given it more kinetic energy than it had before the contacts acted, they are scaled down until it has
/// as much. Momentum is conserved, since impulses stay equal and opposite. Groups that touch a moving
/// kinematic body may gain energy from it.
void limit_impact_energy(WorldState& world, std::span<SolverBody> bodies);

}  // namespace cs550
