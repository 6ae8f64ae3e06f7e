#pragma once
/// @file solve_order.hpp
/// In which order the constraints of a step are solved.

#include <span>
#include <vector>

#include "cs550/contact.hpp"
#include "cs550/rigid_body.hpp"
#include "cs550/static_vector.hpp"

namespace cs550 {

/// Contacts that are solved side by side, by their place in the list.
using ContactGroup = StaticVector<Index, 4>;

/// Where the constraint of each contact point goes, counted over all contacts in turn; and the room in which
/// that is found.
struct SolveOrder {
  std::vector<Index> place_of_point;

  std::vector<Index> first_point;  ///< of each contact
  std::vector<ContactGroup> groups;
  std::vector<Index> group_after_body;
};

/// Puts contacts that share no movable body into groups; of each group first the constraints of their first
/// points, then those of their second ones, and so on, for solvers that take several at a time. Constraints
/// that share a body keep their order, and the others do not see each other: a pass in this order
/// leaves the very bits that a pass in the order of the contacts would.
void arrange_constraints(std::span<const Contact> contacts, std::span<const RigidBody> bodies,
                         SolveOrder& order);

}  // namespace cs550
