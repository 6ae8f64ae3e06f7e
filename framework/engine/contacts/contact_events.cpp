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
    const std::span<const Index> places = world.solve_order.places_of(i);
    // Most pairs are only near. They are not read: all of them together do not fit the cache.
    if (places.empty() && !pairs.touching[i]) continue;
    const Contact& contact = pairs.contacts[i];
    const bool touching = is_touching(world, contact, places);
    if (touching == static_cast<bool>(pairs.touching[i])) continue;
    std::vector<ContactEvent>& events = touching ? world.began : world.ended;
    events.push_back({world.id_at(contact.body_a), world.id_at(contact.body_b)});
    pairs.touching[i] = static_cast<char>(touching);
  }
}

}  // namespace cs550
