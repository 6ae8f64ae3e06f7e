#pragma once
/// @file overlap_recovery.hpp
/// Bodies that were put into each other part without gaining speed.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Finds the pairs that overlap more deeply than their motion explains, and the bodies in contact
/// with them: these recover. @param h step (s)
void find_misplaced_bodies(WorldState& world, Real h);

/// Whether one of the two bodies recovers.
bool recovers(const WorldState& world, const ContactConstraint& constraint);

/// Call it before the passes with bias. Keeps the state of recovering bodies and constraints, and
/// takes their friction away.
void begin_push(WorldState& world);
/// Call it after the bodies have moved. Gives recovering bodies the momenta, and their constraints
/// the friction and impulses, that they had before the push.
void end_push(WorldState& world);
/// Instead of end_push(), where the push is to stay: gives recovering constraints their friction back.
void return_friction(WorldState& world);
/// Prepares recovering constraints for the poses after the push, and applies their impulses again:
/// the relax passes start from them.
void restart_after_push(WorldState& world, std::span<SolverBody> bodies, const ContactStep& step);

}  // namespace cs550
