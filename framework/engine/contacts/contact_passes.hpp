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
  bool store = true;  ///< whether the constraints get the impulses at the end, not only the mirror
  /// ω: a constraint that the last warm start loaded changes its normal impulse by ω times as much. Others do
  /// not: ω times the impulse that stops an impact would throw the body back.
  Real over_relaxation = 1;

  /// The direction of a pass, counted from 0.
  bool goes_backwards(int pass) const { return backwards != (alternate && pass % 2 == 1); }

  /// One of them. The last one marks impacts and stores impulses.
  Passes one(int pass) const {
    const bool last = pass + 1 == count;
    return {.count = 1,
            .backwards = goes_backwards(pass),
            .mark_impacts = mark_impacts && last,
            .store = store && last,
            .over_relaxation = over_relaxation};
  }
};

/// warm_start() for every constraint, if asked for, then solve_contacts() for each pass, then mark_impact() for
/// every constraint, if asked for.
/// @param mirror of the constraints; remembers the loads of the last warm start until it is stale
void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                std::span<SolverBody> bodies, const ContactStep& step, const Passes& passes);

/// Whether run_passes() and resist_rolling() write only bodies that can move, so that several threads may run
/// them for constraints that share no movable body.
bool passes_spare_immovable_bodies();

}  // namespace cs550
