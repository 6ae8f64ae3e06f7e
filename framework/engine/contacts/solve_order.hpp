#pragma once
/// @file solve_order.hpp
/// The order in which the constraints of a step are solved.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Orders the constraints for solvers that take several at a time. Contacts that share no movable
/// body form groups. Within a group the constraints of all first points come first, then those of
/// all second points, and so on. Constraints that share a body keep their order, and the others do
/// not affect each other: a pass in this order gives the same bits as one in the order of the
/// contacts.
void arrange_constraints(std::span<const Contact> contacts, std::span<const RigidBody> bodies,
                         SolveOrder& order);

}  // namespace cs550
