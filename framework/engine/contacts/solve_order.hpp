#pragma once
/// @file solve_order.hpp
/// The order in which the constraints of a step are solved.

#include <span>
#include <vector>

#include "cs550/contact.hpp"
#include "cs550/rigid_body.hpp"
#include "cs550/static_vector.hpp"

namespace cs550 {

/// Contacts that are solved side by side, by their index in the list.
using ContactGroup = StaticVector<Index, 4>;

/// The index of the constraint of each contact point, with the points of all contacts counted in
/// turn; and the working storage of arrange_constraints().
struct SolveOrder {
  std::vector<Index> place_of_point;

  std::vector<Index> first_point;  ///< of each contact
  std::vector<ContactGroup> groups;
  std::vector<Index> group_after_body;
};

/// Orders the constraints for solvers that take several at a time. Contacts that share no movable
/// body form groups. Within a group the constraints of all first points come first, then those of
/// all second points, and so on. Constraints that share a body keep their order, and the others do
/// not affect each other: a pass in this order gives the same bits as one in the order of the
/// contacts.
void arrange_constraints(std::span<const Contact> contacts, std::span<const RigidBody> bodies,
                         SolveOrder& order);

}  // namespace cs550
