#include <algorithm>

#include "engine/contacts/contact_constraints.hpp"

namespace cs550 {

bool is_touching(const WorldState& world, Index contact, std::span<const Index> places) {
  const Manifold& manifold = world.pairs.contacts[contact].manifold;
  return std::any_of(places.begin(), places.end(),
                     [&](Index place) { return world.constraints[place].impact_handled; }) ||
         std::any_of(manifold.points.begin(), manifold.points.end(),
                     [](const ContactPoint& point) { return point.separation <= 0; });
}

void report_touching(WorldState& world) {
  PairList& pairs = world.pairs;
  if (world.touches == pairs.touching) return;  // most steps of a scene at rest
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (world.touches[i] == pairs.touching[i]) continue;
    const PairSummary& pair = pairs.summaries[i];
    std::vector<ContactEvent>& events = world.touches[i] ? world.began : world.ended;
    events.push_back({world.id_at(pair.body_a), world.id_at(pair.body_b)});
    pairs.touching[i] = world.touches[i];
  }
}

}  // namespace cs550
