#pragma once
/// @file solve_order.hpp
/// The order in which the constraints of a step are solved.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Orders the constraints of a step. Contacts keep their order, but those whose normals are across gravity, up to
/// 6°, come after the others, which carry the weight.
///
/// Then they are placed for solvers that take several at a time. Contacts that share no movable body form
/// groups. Within a group the constraints of all first points come first, then those of all second points, and
/// so on. Constraints that share a body keep their order, and the others do not affect each other: a pass over
/// the groups gives the same bits as one over the contacts in the order above.
/// @param gravity in the world frame; zero leaves the order of the contacts
void arrange_constraints(const PairList& pairs, std::span<const RigidBody> bodies,
                         const Vec3& gravity, SolveOrder& order);

/// Lets the mirror have the groups of the order, so that the points of a contact stay together.
void keep_groups(const SolveOrder& order, ConstraintMirror& mirror);

}  // namespace cs550
