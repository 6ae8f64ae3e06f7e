#pragma once
/// @file contact_passes.hpp
/// The contact solver's passes over all constraints. The definition here calls the functions of lab 7.
/// `solutions/lab7_constraint_solver/fast/` replaces it with a faster form that leaves the same bits.

#include <span>

#include "cs550/constraint_solver.hpp"
#include "engine/constraint_mirror.hpp"
#include "engine/passes.hpp"

namespace cs550 {

/// warm_start() for every constraint, if asked for, then solve_contacts() for each pass, then mark_impact() for
/// every constraint, if asked for. The form here changes the constraints themselves. A faster one may leave impulses and
/// marks in the mirror (`is_ahead`) until passes with `store` copy them.
/// @param mirror of the constraints; remembers the loads of the last warm start until it is stale
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes);

/// Whether run_passes() and resist_rolling() write only bodies that can move, so that several threads may run
/// them for constraints that share no movable body.
bool passes_spare_immovable_bodies();

}  // namespace cs550
