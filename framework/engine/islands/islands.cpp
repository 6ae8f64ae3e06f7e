#include "engine/islands/islands.hpp"

#include "engine/islands/forest.hpp"

namespace cs550 {

namespace {

bool is_awake(const RigidBody& body) { return body.kind == BodyKind::Dynamic && !body.asleep; }

void join_touching_bodies(WorldState& world) {
  std::vector<Index>& parent = world.sleeping.parent;
  plant_forest(parent, world.slot_count());
  for (const PairSummary& pair : world.pairs.summaries) {
    if (pair.points == 0) continue;
    if (is_awake(world.bodies[pair.body_a]) && is_awake(world.bodies[pair.body_b])) {
      join(parent, pair.body_a, pair.body_b);
    }
  }
}

/// Marks the islands that an immovable body supports. If that moves, the island stays awake.
void find_supports(WorldState& world) {
  Sleeping& sleeping = world.sleeping;
  const auto support = [&](Index dynamic, Index other) {
    if (!is_awake(world.bodies[dynamic]) || world.bodies[other].kind == BodyKind::Dynamic) return;
    const Index root = root_of(sleeping.parent, dynamic);
    sleeping.supported[root] = 1;
    if (!sleeping.bodies[other].settled) sleeping.stays_awake[root] = 1;
  };
  for (const PairSummary& pair : world.pairs.summaries) {
    if (pair.points == 0) continue;
    support(pair.body_a, pair.body_b);
    support(pair.body_b, pair.body_a);
  }
}

bool is_still(const RigidBody& body) {
  return body.linear_momentum.isZero(0) && body.angular_momentum.isZero(0);
}

/// Marks the islands with a body that is not at rest.
void find_restless_bodies(WorldState& world) {
  Sleeping& sleeping = world.sleeping;
  for (Index i = 0; i < static_cast<Index>(world.slot_count()); ++i) {
    const RigidBody& body = world.bodies[i];
    if (!is_awake(body)) continue;
    const Index root = root_of(sleeping.parent, i);
    const bool drifts = !sleeping.supported[root] && !is_still(body);
    if (!sleeping.bodies[i].settled || drifts) sleeping.stays_awake[root] = 1;
  }
}

bool any_settled(const WorldState& world) {
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    if (is_awake(world.bodies[i]) && world.sleeping.bodies[i].settled) return true;
  }
  return false;
}

}  // namespace

bool find_resting_islands(WorldState& world) {
  if (!any_settled(world)) return false;
  Sleeping& sleeping = world.sleeping;
  sleeping.stays_awake.assign(world.slot_count(), 0);
  sleeping.supported.assign(world.slot_count(), 0);
  join_touching_bodies(world);
  find_supports(world);
  find_restless_bodies(world);

  bool any = false;
  sleeping.island_of.assign(world.slot_count(), no_index);
  for (Index i = 0; i < static_cast<Index>(world.slot_count()); ++i) {
    if (!world.slots[i].alive || !is_awake(world.bodies[i])) continue;
    const Index root = root_of(sleeping.parent, i);
    if (sleeping.stays_awake[root]) continue;
    sleeping.island_of[i] = root;
    any = true;
  }
  return any;
}

}  // namespace cs550
