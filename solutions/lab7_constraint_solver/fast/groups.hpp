#pragma once
/// @file groups.hpp
/// Which constraints are solved side by side.

#include <span>

#include "cs550/constraint_solver.hpp"
#include "engine/constraint_mirror.hpp"

namespace cs550 {

/// Finds groups and rows of the mirror.
///
/// Constraints that share no movable body do not affect each other: solved together they give the
/// same result as one after the other. Neighbours in the array are solved together as long as that
/// holds, and the world puts such constraints side by side (solve_order.cpp).
void find_groups(std::span<const ContactConstraint> constraints, std::span<const SolverBody> bodies,
                 ConstraintMirror& mirror);

}  // namespace cs550
