#include <algorithm>

#include "engine/contacts/contact_constraints.hpp"

namespace cs550 {

namespace {

/// Whether a contact pushed at any time in this step, or its surfaces met.
bool is_touching(const WorldState& world, const Contact& contact, std::span<const Index> places) {
  return std::any_of(places.begin(), places.end(),
                     [&](Index place) { return world.constraints[place].impact_handled; }) ||
         std::any_of(contact.manifold.points.begin(), contact.manifold.points.end(),
                     [](const ContactPoint& point) { return point.separation <= 0; });
}

}  // namespace

void note_touching(WorldState& world) {
  PairList& pairs = world.pairs;
  for (Index i = 0; i < static_cast<Index>(pairs.size()); ++i) {
    const Contact& contact = pairs.contacts[i];
    const bool touching = is_touching(world, contact, world.solve_order.places_of(i));
    const ContactEvent event{world.id_at(contact.body_a), world.id_at(contact.body_b)};
    if (touching && !pairs.touching[i]) world.began.push_back(event);
    if (!touching && pairs.touching[i]) world.ended.push_back(event);
    pairs.touching[i] = static_cast<char>(touching);
  }
}

}  // namespace cs550
