#include "engine/islands/sleeping.hpp"

#include <algorithm>

#include "engine/contacts/contact_constraints.hpp"
#include "engine/islands/islands.hpp"
#include "engine/pairs/pair_list.hpp"

namespace cs550 {

namespace {

bool is_same(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

bool touches(const PairSummary& pair) { return pair.points > 0; }

bool was_put_to_sleep(const BodyRest& rest) { return rest.island != no_index; }

bool is_pushed(const RigidBody& body) { return !body.force.isZero(0) || !body.torque.isZero(0); }

/// Whether the owner of the world has changed a sleeping body.
bool is_disturbed(const RigidBody& body, const BodyRest& rest) {
  const bool still =
      body.asleep && body.linear_momentum.isZero(0) && body.angular_momentum.isZero(0);
  return !still || is_pushed(body) || !is_same(body.pose, rest.start);
}

/// Whether the owner of the world has changed a body that is awake since the last step.
bool is_changed(const RigidBody& body, const LeftBody& left) {
  return !is_same(body.pose, left.pose) || body.linear_momentum != left.linear_momentum ||
         body.angular_momentum != left.angular_momentum;
}

/// Whether an immovable body moves, or was moved since the last step.
bool moves(const RigidBody& body, const BodyRest& rest) {
  const bool has_velocity = body.kind == BodyKind::Kinematic &&
                            !(body.linear_velocity.isZero(0) && body.angular_velocity.isZero(0));
  return has_velocity || !is_same(body.pose, rest.start);
}

/// Sleeping, or immovable and still.
bool is_at_rest(const WorldState& world, Index body) {
  if (world.bodies[body].kind == BodyKind::Dynamic) return world.bodies[body].asleep;
  return world.sleeping.bodies[body].settled;
}

/// Marks the island of a sleeping body.
void mark(WorldState& world, Index body) {
  const BodyRest& rest = world.sleeping.bodies[body];
  if (was_put_to_sleep(rest)) world.sleeping.wakes[rest.island] = 1;
}

void mark_both(WorldState& world, const PairSummary& pair) {
  mark(world, pair.body_a);
  mark(world, pair.body_b);
}

/// Makes room for new bodies. No step has left them as they are, so their windows begin now.
void watch_new_bodies(WorldState& world) {
  world.sleeping.bodies.resize(world.slot_count());
  world.sleeping.left.resize(world.slot_count());
}

void begin_marking(WorldState& world) { world.sleeping.wakes.assign(world.slot_count(), 0); }

/// Returns the sleeping pairs to the world that have a body which is no longer at rest.
void return_pairs(WorldState& world) {
  PairList& pairs = world.sleeping.pairs;
  std::vector<char>& moved = world.sleeping.moved_pairs;
  moved.clear();
  for (const PairSummary& pair : pairs.summaries) {
    moved.push_back(!is_at_rest(world, pair.body_a) || !is_at_rest(world, pair.body_b));
  }
  if (std::find(moved.begin(), moved.end(), char{1}) == moved.end()) return;
  fit_loads(pairs, moved, world.sleeping.substep_length, world.substep_length);
  move_pairs(pairs, world.pairs, world.next_pairs, moved);
}

/// Wakes all bodies of the marked islands.
void wake_marked(WorldState& world) {
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    RigidBody& body = world.bodies[i];
    BodyRest& rest = world.sleeping.bodies[i];
    if (!was_put_to_sleep(rest) || !world.sleeping.wakes[rest.island]) continue;
    body.asleep = false;
    rest.island = no_index;
    restart_window(body, rest);
  }
  return_pairs(world);
}

/// Wakes all bodies, and lets none be at rest.
void wake_all(WorldState& world) {
  world.sleeping.wakes.assign(world.slot_count(), 1);
  wake_marked(world);
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    restart_window(world.bodies[i], world.sleeping.bodies[i]);
  }
}

/// Marks the islands of bodies that were changed, and finds the immovable bodies that move. A body that is
/// pushed or was changed while it was awake is at rest no more.
/// @returns whether there are any of either
bool find_disturbances(WorldState& world) {
  bool any = false;
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    RigidBody& body = world.bodies[i];
    BodyRest& rest = world.sleeping.bodies[i];
    if (!world.slots[i].alive) continue;
    if (!was_put_to_sleep(rest)) body.asleep = false;  // only the world puts a body to sleep
    if (body.kind != BodyKind::Dynamic) {
      rest.settled = !moves(body, rest);
      rest.start = body.pose;
      any = any || !rest.settled;
    } else if (was_put_to_sleep(rest)) {
      if (!is_disturbed(body, rest)) continue;
      mark(world, static_cast<Index>(i));
      any = true;
    } else if (is_pushed(body) || is_changed(body, world.sleeping.left[i])) {
      restart_window(body, rest);
    }
  }
  return any;
}

/// A body that is awake is at rest no more.
void restart(WorldState& world, Index body) {
  const RigidBody& awake = world.bodies[body];
  if (awake.kind != BodyKind::Dynamic || awake.asleep) return;
  restart_window(awake, world.sleeping.bodies[body]);
}

/// Marks the islands that immovable bodies in motion carry. What they carry and is awake is at rest no more.
void mark_carried(WorldState& world) {
  const auto carries = [&](Index body) {
    return world.bodies[body].kind != BodyKind::Dynamic && !is_at_rest(world, body);
  };
  for (const PairSummary& pair : world.sleeping.pairs.summaries) {
    if (touches(pair) && (carries(pair.body_a) || carries(pair.body_b))) mark_both(world, pair);
  }
  for (const PairSummary& pair : world.pairs.summaries) {
    if (!touches(pair)) continue;
    if (carries(pair.body_a)) restart(world, pair.body_b);
    if (carries(pair.body_b)) restart(world, pair.body_a);
  }
}

void restart_both(WorldState& world, Index body_a, Index body_b) {
  restart(world, body_a);
  restart(world, body_b);
}

/// A body may rest on one that is awake. If that goes away, the body is at rest no more.
void restart_where_contacts_ended(WorldState& world) {
  const PairList& pairs = world.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PairSummary& pair = pairs.summaries[i];
    if (pairs.touching[i] && !touches(pair)) restart_both(world, pair.body_a, pair.body_b);
  }
  // Those that are not even near any more. A body in the place of a removed one has a new window anyway.
  for (const ContactEvent& pair : world.ended) restart_both(world, pair.a.index, pair.b.index);
}

/// Wakes the sleeping bodies of the world's pairs that have contact points.
void wake_touched(WorldState& world) {
  bool any = false;
  for (const PairSummary& pair : world.pairs.summaries) {
    if (!touches(pair)) continue;
    if (!world.bodies[pair.body_a].asleep && !world.bodies[pair.body_b].asleep) continue;
    if (!any) begin_marking(world);
    any = true;
    mark_both(world, pair);
  }
  if (any) wake_marked(world);
}

void put_to_sleep(RigidBody& body, BodyRest& rest, Index island) {
  body.asleep = true;
  body.linear_momentum.setZero();
  body.angular_momentum.setZero();
  body.linear_velocity.setZero();
  body.angular_velocity.setZero();
  rest.start = body.pose;
  rest.island = island;
}

/// Puts the islands at rest to sleep, with their pairs.
void put_islands_to_sleep(WorldState& world) {
  if (!find_resting_islands(world)) return;
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    const Index island = world.sleeping.island_of[i];
    if (island != no_index) put_to_sleep(world.bodies[i], world.sleeping.bodies[i], island);
  }
  std::vector<char>& moved = world.sleeping.moved_pairs;
  moved.clear();
  for (const PairSummary& pair : world.pairs.summaries) {
    moved.push_back(is_at_rest(world, pair.body_a) && is_at_rest(world, pair.body_b));
  }
  if (world.sleeping.pairs.size() == 0) world.sleeping.substep_length = world.substep_length;
  fit_loads(world.pairs, moved, world.substep_length, world.sleeping.substep_length);
  move_pairs(world.pairs, world.sleeping.pairs, world.next_pairs, moved);
}

}  // namespace

bool move_alike(const WorldSettings& one, WorldSettings other) {
  other.threads = one.threads;
  other.adaptive_threads = one.adaptive_threads;
  other.check_stages = one.check_stages;
  other.audit_momentum = one.audit_momentum;
  return one == other;
}

void wake_disturbed_bodies(WorldState& world) {
  Sleeping& sleeping = world.sleeping;
  watch_new_bodies(world);
  if (!move_alike(sleeping.settings, world.settings)) {
    sleeping.settings = world.settings;
    wake_all(world);
  }
  if (!world.settings.sleeping) return;
  begin_marking(world);
  if (!find_disturbances(world)) return;
  mark_carried(world);
  wake_marked(world);
}

void update_sleep(WorldState& world) {
  if (!world.settings.sleeping) return;
  restart_where_contacts_ended(world);
  wake_touched(world);
  put_islands_to_sleep(world);
  world.stats.asleep = static_cast<int>(std::count_if(
      world.bodies.begin(), world.bodies.end(), [](const RigidBody& body) { return body.asleep; }));
}

void wake_around(WorldState& world, const std::vector<char>& bodies) {
  const auto for_them = [&](const auto& visit) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i]) visit(static_cast<Index>(i));
    }
  };
  const auto concerns_them = [&](const PairSummary& pair) {
    return touches(pair) && (bodies[pair.body_a] || bodies[pair.body_b]);
  };
  watch_new_bodies(world);
  begin_marking(world);
  for_them([&](Index body) { mark(world, body); });
  for (const PairSummary& pair : world.sleeping.pairs.summaries) {
    if (concerns_them(pair)) mark_both(world, pair);
  }
  for (const PairSummary& pair : world.pairs.summaries) {
    if (concerns_them(pair)) restart_both(world, pair.body_a, pair.body_b);
  }
  // So that their pairs return to the world.
  for_them([&](Index body) { world.sleeping.bodies[body].settled = false; });
  wake_marked(world);
  for_them([&](Index body) {
    world.sleeping.bodies[body] = {};
    world.sleeping.left[body] = {};
  });
}

}  // namespace cs550
