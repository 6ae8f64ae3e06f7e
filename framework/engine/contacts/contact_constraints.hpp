#pragma once
/// @file contact_constraints.hpp
/// ContactConstraint[], one element for each contact point, from its making to the impulses that
/// the contact points keep for the next step.

#include <span>

#include "engine/contacts/solve_order.hpp"
#include "engine/prefetch.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Finds the solve order of a step's contacts, and from time to time the parts of the bodies.
void arrange_contacts(WorldState& world);
/// Measures the bodies, forgets their displacements, and makes room for the constraints of a step.
/// @pre arrange_contacts()
void begin_constraints(WorldState& world);
/// Makes the constraints of a contact, without masses, or of all contacts. @pre begin_constraints()
/// @{
void make_constraints(WorldState& world, Index contact);
void make_constraints(WorldState& world);
/// @}

/// Notes how far bodies have turned since the step began, and turn within a substep. Call it once they have moved.
/// @param first, last the bodies from `first` to `last` − 1
/// @param h substep (s)
void measure_turns(WorldState& world, std::size_t first, std::size_t last, Real h);
/// When a step begins, no body has turned.
void forget_turns(WorldState& world);

/// Recomputes the masses of constraints whose bodies have turned far since the step began, and turns
/// the levers of thin bodies. Call it before the impulses of a substep are applied: those that no
/// longer suit the masses are limited.
///
/// A pass lowers the kinetic energy only if the masses belong to the present inertia. With twice
/// the effective mass that a constraint has, every pass overshoots further than the last.
void refresh_masses(WorldState& world, const ContactStep& step);
/// The same for the constraints of a unit of the solve order. @pre bodies are numbered part by part
void refresh_masses(WorldState& world, const ContactStep& step, std::size_t unit);
/// Recomputes the masses of constraints whose bodies have turned far for their thinness within this
/// substep. Call it before the relax passes: the impulses have been applied and stay as they are.
void refresh_masses_of_thin_bodies(WorldState& world, const ContactStep& step);
/// The same for the constraints of a unit of the solve order. @pre bodies are numbered part by part
void refresh_masses_of_thin_bodies(WorldState& world, const ContactStep& step, std::size_t unit);

/// Gives the constraints the impulses and marks of the last passes, which may be in the mirrors only. Whatever
/// reads or changes constraints between passes calls it first.
/// @{
void read_back_impulses(WorldState& world);
void read_back_impulses(WorldState& world, std::size_t unit);
/// @}

/// The kinetic energy that the impulses of a contact's constraints give to bodies at rest, each
/// impulse alone (J).
double impulse_energy(const WorldState& world, std::span<const Index> places);
/// Scales the impulses of a contact down to the energy that they had before, if it has more than
/// doubled and they would throw the bodies apart faster than overlap may.
void limit_impulse_energy(WorldState& world, const ContactStep& step, std::span<const Index> places,
                          double before);
/// Does so for the impulses that a contact has carried from the last step.
void limit_carried_impulses(WorldState& world, const ContactStep& step, Index contact);

/// Notes whether a contact has no impulses yet and is slow. What stops a slow contact seldom closes a gap that takes
/// more speed, and most contacts without impulses are across such gaps.
/// @pre cold_start.is_pair_cold has an element for each contact
/// @param h substep (s)
void note_if_cold(WorldState& world, Index contact, Real h);
/// Estimates the impulses of resting contacts that have none from the step before. @pre note_if_cold() for all
/// @param h substep (s)
void guess_cold_impulses(WorldState& world, Real h);

/// Makes the impulses of the world's contact points those of substeps of another length: a load is a force, so its
/// impulse grows with the time. Pairs of sleeping bodies keep theirs.
/// @param h substep (s)
void fit_impulses(WorldState& world, Real h);
/// The same for chosen pairs of bodies at rest, whose impulses carry nothing but weight.
/// @param before, now substeps (s)
void fit_loads(PairList& pairs, const std::vector<char>& chosen, Real before, Real now);

/// Copies the accumulated impulses to the contact points, for the next step's warm start, and notes which
/// contacts touch.
void store_impulses(WorldState& world);

/// Whether a contact pushed at any time in this step, or its surfaces met.
bool is_touching(const WorldState& world, Index contact, std::span<const Index> places);
/// Reports the pairs that began or ceased to touch in this step. @pre store_impulses()
void report_touching(WorldState& world);

/// The constraints of a unit of the solve order.
inline std::span<ContactConstraint> constraints_of(WorldState& world, const SolveUnit& unit) {
  const auto count = static_cast<std::size_t>(unit.end_place - unit.first_place);
  return std::span(world.constraints).subspan(static_cast<std::size_t>(unit.first_place), count);
}

/// Calls `visit(contact, places)` for every contact with points: its index, and the indices of its
/// points' constraints, in the order of the points.
/// @pre solve_order is that of the current contact points
template <class Visit>
void for_constraints_of_contacts(const WorldState& world, const Visit& visit) {
  for (const Index contact : world.solve_order.contacts) {
    visit(contact, world.solve_order.places_of(contact));
  }
}

/// The contacts of a group are far from each other in memory, so they are fetched while the group before is visited.
inline void prefetch_contacts(const PairList& pairs, const ContactGroup& group) {
  for (const Index contact : group) prefetch(&pairs.contacts[contact], sizeof(Contact));
}

/// Calls `visit(group, constraints)` for every group of the solve order: its contacts and their constraints,
/// which are neighbours in the array. Several threads share the groups if there are any. A visit may change
/// only these contacts and constraints.
template <class Visit>
void for_groups_in_blocks(WorldState& world, const Visit& visit) {
  const SolveOrder& order = world.solve_order;
  const auto visit_groups = [&](std::span<const ContactGroup> groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (i + 1 < groups.size()) prefetch_contacts(world.pairs, groups[i + 1]);
      const ContactGroup& group = groups[i];
      std::size_t points = 0;
      for (const Index contact : group) points += order.places_of(contact).size();
      const auto begin = static_cast<std::size_t>(order.places_of(group[0])[0]);
      visit(group, std::span(world.constraints).subspan(begin, points));
    }
  };
  if (order.units.size() > 1) {
    for_units(world.team, order, [&](std::size_t unit) { visit_groups(order.units[unit].groups); });
    return;
  }
  constexpr std::size_t block = 4;
  const std::span<const ContactGroup> groups = order.units[0].groups;
  for_blocks(world.team, groups.size(), block, [&](std::size_t first, std::size_t last) {
    visit_groups(groups.subspan(first, last - first));
  });
}

/// The same as for_constraints_of_contacts() by several threads, if there are any. A visit may change only its
/// contact and constraints.
template <class Visit>
void for_constraints_of_contacts_in_blocks(const WorldState& world, const Visit& visit) {
  constexpr std::size_t block = 16;
  const std::vector<Index>& contacts = world.solve_order.contacts;
  for_blocks(world.team, contacts.size(), block, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      visit(contacts[i], world.solve_order.places_of(contacts[i]));
    }
  });
}

}  // namespace cs550
