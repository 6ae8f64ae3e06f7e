#pragma once
/// @file passes.hpp
/// Which passes the contact solver makes.

#include "cs550/math.hpp"

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
  /// Whether the constraints get impulses and marks at the end, including those of earlier passes that only the mirror has.
  bool store = true;
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

}  // namespace cs550
