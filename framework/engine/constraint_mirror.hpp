#pragma once
/// @file constraint_mirror.hpp
/// A copy of the contact constraints in structure-of-arrays form, for passes that solve eight of them
/// at a time. Passes change impulses and marks in the mirror, and copy them to the constraints when asked to.

#include <array>
#include <vector>

#include "cs550/math.hpp"
#include "engine/lane_count.hpp"

namespace cs550 {

/// Up to eight pairs of bodies that share no movable body, and their constraints. Neighbours in the
/// array of constraints are in the same group, and they keep their order: a *row* is one constraint of
/// each pair, the next row has the next constraints.
struct PairGroup {
  std::array<Index, lane_count> bodies_a;  ///< no_index in unused lanes
  std::array<Index, lane_count> bodies_b;
  Index first_row = 0;
  Index row_count = 0;
  bool has_immovable = false;  ///< whether a body of the group is immovable
};

/// Where the constraints of a row are in the array.
struct ConstraintRow {
  Index first = 0;
  Index count = 0;  ///< they fill the first lanes
};

/// Two numbers of each constraint of a row: a cache line.
struct alignas(2 * lane_count * sizeof(Real)) LaneNumbers {
  Real lane[2 * lane_count];
};

/// The mirror of an array of constraints.
struct ConstraintMirror {
  // Whenever anything but a pass has changed the constraints, set one of:
  bool stale = true;
  bool stale_numbers = true;   ///< enough if they still have the same bodies and places
  bool stale_impulses = true;  ///< enough if only impulses or marks have changed
  /// Whether the constraints lack impulses and marks of the last passes. Neither `stale_numbers` nor `stale_impulses` may
  /// be set meanwhile.
  bool is_ahead = false;
  std::vector<Index> starts;  ///< constraints with which a group has to begin; may be empty
  std::vector<PairGroup> groups;
  std::vector<ConstraintRow> rows;
  std::vector<Index> last_group;  ///< of each body: the last group that moves it; working storage
  std::vector<LaneNumbers> numbers;  ///< of each row in turn, laid out by the passes
  std::vector<Real> loads;           ///< where no fast form keeps them: λ_n of the last warm start
  std::vector<Real> masses;          ///< working storage: normal masses during over-relaxed passes
};

/// The mirrors of the units of a solve order.
struct ConstraintMirrors {
  std::vector<ConstraintMirror> of_units;

  /// Call it for new constraints. It drops the impulses of the former ones.
  void set_stale() {
    for (ConstraintMirror& mirror : of_units) {
      mirror.stale = true;
      mirror.is_ahead = false;
    }
  }
  /// See ConstraintMirror.
  /// @{
  void set_stale_numbers() {
    for (ConstraintMirror& mirror : of_units) mirror.stale_numbers = true;
  }
  void set_stale_impulses() {
    for (ConstraintMirror& mirror : of_units) mirror.stale_impulses = true;
  }
  /// @}
};

}  // namespace cs550
