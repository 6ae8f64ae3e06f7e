#pragma once
/// @file contact_constraints.hpp
/// ContactConstraint[], one element for each contact point, from its making to the impulses that
/// the contact points keep for the next step.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Makes the constraints of a step, in the order in which they are solved.
void make_constraints(WorldState& world);

/// Recomputes the masses of constraints whose bodies have turned far since the step began: their
/// world inertia has changed.
void refresh_masses(WorldState& world, const ContactStep& step);

/// Estimates the impulses of resting contacts that have none from the step before.
/// @param h substep (s)
void guess_cold_impulses(WorldState& world, Real h);

/// Copies the accumulated impulses to the contact points, for the next step's warm start.
void store_impulses(WorldState& world);

/// Reports the pairs that began or ceased to touch in this step.
void note_touching(WorldState& world);

/// Calls `visit(contact, places)` for every contact. The places are the indices of its points'
/// constraints, in the order of the points.
/// @pre solve_order is that of the current contact points
template <class Visit>
void for_constraints_of_contacts(WorldState& world, const Visit& visit) {
  std::span<const Index> places = world.solve_order.place_of_point;
  for (Contact& contact : world.pairs.contacts) {
    const std::size_t points = contact.manifold.points.size();
    visit(contact, places.first(points));
    places = places.subspan(points);
  }
}

}  // namespace cs550
