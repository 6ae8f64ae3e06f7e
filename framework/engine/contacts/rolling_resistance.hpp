#pragma once
/// @file rolling_resistance.hpp
/// The torque of contact patches. The definition here visits one contact after the other.
/// `solutions/lab7_constraint_solver/fast/` replaces it with a faster form that leaves the same bits.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Lets one contact after the other oppose the rotation of its bodies relative to each other, by an
/// angular impulse of at most `lever` times the sum of its normal impulses.
/// @param mirror of the constraints, up to date and with the groups of the order, see keep_groups(); used by
///               the fast form only
/// @param order of the constraints
/// @param constraints the fast form finds their impulses in the mirror
/// @param lever m
void resist_rolling(ConstraintMirror& mirror, const SolveOrder& order,
                    std::span<const ContactConstraint> constraints, std::span<SolverBody> bodies,
                    Real lever);

}  // namespace cs550
