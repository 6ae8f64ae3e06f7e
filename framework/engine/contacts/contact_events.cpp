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
  auto touched = world.pairs.touching.begin();
  for_constraints_of_contacts(world, [&](const Contact& contact, std::span<const Index> places) {
    const bool touching = is_touching(world, contact, places);
    const ContactEvent event{world.id_at(contact.body_a), world.id_at(contact.body_b)};
    if (touching && !*touched) world.began.push_back(event);
    if (!touching && *touched) world.ended.push_back(event);
    *touched++ = static_cast<char>(touching);
  });
}

}  // namespace cs550
