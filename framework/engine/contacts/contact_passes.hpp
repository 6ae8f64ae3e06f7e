#pragma once
/// @file contact_passes.hpp
/// The contact solver's passes over all constraints. The definition here calls the functions of lab 7.
/// `solutions/lab7_constraint_solver/fast/` replaces it with a faster form that leaves the same bits.

#include <span>

#include "cs550/constraint_solver.hpp"
#include "engine/constraint_mirror.hpp"

namespace cs550 {

/// Consecutive passes of a substep. If they alternate, two of them together are symmetric (see
/// solve_contacts()).
struct Passes {
  bool warm_start = false;  ///< whether the accumulated impulses are applied first
  int count = 0;
  bool backwards = false;  ///< the direction of the first pass
  bool alternate = true;   ///< whether each pass goes the other way than the one before
  bool mark_impacts =
      false;  ///< whether constraints are marked at the end: ContactConstraint::mark_impact()

  /// The direction of a pass, counted from 0.
  bool goes_backwards(int pass) const { return backwards != (alternate && pass % 2 == 1); }
};

/// warm_start() for every constraint, if asked for, then solve_contacts() for each pass, then mark_impact() for
/// every constraint, if asked for.
/// @param mirror of the constraints; used by the fast form only
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes);

}  // namespace cs550
