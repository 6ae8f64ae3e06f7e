#pragma once
/// @file solve_order.hpp
/// The order in which the constraints of a step are solved.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Orders the constraints of a step. Contacts inside parts come first, part by part, then those between parts 0 and
/// 1, 2 and 3, and so on, then those between 1 and 2, 3 and 4, and so on, then all others. Each of these is a unit.
/// Its contacts keep their order, but those whose normals are across gravity, up to 6°, come after the others, which
/// carry the weight, and some rows of a part are turned (row_order.hpp). Contacts between parts have colours: those of
/// the first come first, and as long as four are enough, no two of one colour share a body.
///
/// Then they are placed for solvers that take several at a time. Contacts that share no movable body form
/// groups. Within a group the constraints of all first points come first, then those of all second points, and
/// so on. Constraints that share a body keep their order, and the others do not affect each other: a pass over
/// the groups gives the same bits as one over the contacts in the order above.
/// @param gravity in the world frame; if it is zero, no contact comes last
/// @param order that of the last step, or a new one. The result is the same: what has not changed is only kept.
/// @param parts of the bodies
/// @param team that will solve the units; without one they become a single unit, in the same order
void arrange_constraints(const PairList& pairs, std::span<const RigidBody> bodies,
                         const Vec3& gravity, SolveOrder& order, const BodyParts& parts = {},
                         ThreadTeam* team = nullptr);

/// Lets the mirrors have the groups of the order, so that the points of a contact stay together.
void keep_groups(const SolveOrder& order, ConstraintMirrors& mirrors, ThreadTeam* team = nullptr);

/// Calls `visit(unit)` with the index of each unit of a phase. Several threads share them if there are any; with as
/// many parts, each begins with its own in every call.
template <class Visit>
void for_units_of_phase(ThreadTeam* team, const SolveOrder& order, std::size_t phase,
                        const Visit& visit) {
  const std::size_t begin = order.phases[phase];
  for_blocks(team, order.phases[phase + 1] - begin, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t unit = begin + first; unit < begin + last; ++unit) visit(unit);
  });
}

/// The same for all units, one phase after the other.
template <class Visit>
void for_units_by_phase(ThreadTeam* team, const SolveOrder& order, bool backwards,
                        const Visit& visit) {
  for (std::size_t i = 0; i < phase_count; ++i) {
    for_units_of_phase(team, order, backwards ? phase_count - 1 - i : i, visit);
  }
}

/// The same for all units in a single loop. A visit may change nothing that other units read or change.
template <class Visit>
void for_units(ThreadTeam* team, const SolveOrder& order, const Visit& visit) {
  for_blocks(team, order.units.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t unit = first; unit < last; ++unit) visit(unit);
  });
}

}  // namespace cs550
