#include "engine/pairs/near_pairs.hpp"

#include <algorithm>

#include "engine/pairs/pair_list.hpp"

namespace cs550 {

namespace {

/// The farthest that a point of a body's surface may travel in a step (m).
Real travel(const RigidBody& body, Real spin_speed, Real gravity, Real h) {
  const Real fall = body.kind == BodyKind::Dynamic ? gravity * h : 0;
  return h * (body.linear_velocity.norm() + spin_speed + fall);
}

bool may_touch(const WorldState& world, Index a, Index b) {
  if (world.bodies[a].kind != BodyKind::Dynamic && world.bodies[b].kind != BodyKind::Dynamic) {
    return false;
  }
  const CollisionFilter& filter_a = world.definitions[a].filter;
  const CollisionFilter& filter_b = world.definitions[b].filter;
  return (filter_a.mask & filter_b.category) != 0 && (filter_b.mask & filter_a.category) != 0;
}

/// Gives a body's leaf a new box and remembers to look for new pairs.
void move_leaf(WorldState& world, Index body, const Bounds& bounds) {
  world.tree.move(world.slots[body].leaf, bounds);
  world.moved.push_back(body);
}

/// The room that a stored box leaves on every side, so that it can stay for some steps (m).
Real leaf_room(const WorldState& world) { return Real(0.03) * world.settings.length_unit; }

/// How much larger than its shape's bounds a body's swept bounds are (m).
Real sweep_margin(const WorldState& world, std::size_t body, Real h) {
  const Real gravity = world.settings.gravity.norm();
  return 2 * world.slop() + travel(world.bodies[body], world.slots[body].spin_speed, gravity, h);
}

/// The box to store for a body: its swept bounds now and two steps ahead. Room only where the body goes keeps
/// bodies that fly side by side from being pairs.
Bounds box_to_store(const WorldState& world, std::size_t body, Real h) {
  constexpr int steps_ahead = 2;
  const Bounds& swept = world.slots[body].swept_bounds;
  const Vec3 way = steps_ahead * h * world.bodies[body].linear_velocity;
  Bounds box = swept;
  box.include(Bounds{swept.lower + way, swept.upper + way});
  return box.expanded(leaf_room(world));
}

/// A leaf moves only if the swept bounds of its body leave the stored box, or if the box has become
/// far too large for a body that has slowed down.
bool leaf_is_stale(const WorldState& world, std::size_t body, Real h) {
  const Bounds& stored = world.tree.bounds(world.slots[body].leaf);
  if (!stored.contains(world.slots[body].swept_bounds)) return true;
  const Vec3 excess = stored.extent() - box_to_store(world, body, h).extent();
  return excess.maxCoeff() > 8 * leaf_room(world);
}

bool is_awake(const WorldState& world, std::size_t body) {
  return world.slots[body].alive && !world.bodies[body].asleep;
}

bool are_equal(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

/// The bounds of a body's shape now. A step begins with the poses at which the last one ended, so they are kept.
const Bounds& present_bounds(WorldState& world, std::size_t body) {
  BodyBounds& kept = world.bounds[body];
  const PosedShape posed = world.posed_shape(static_cast<Index>(body));
  if (!are_equal(kept.pose, posed.pose)) kept = {posed.pose, world_bounds(posed)};
  return kept.bounds;
}

/// Updates every body's swept bounds, and finds the leaves that do not suit them.
void sweep_bounds(WorldState& world, Real h) {
  world.outgrown.assign(world.slot_count(), 0);
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!is_awake(world, i)) continue;
      BodySlot& slot = world.slots[i];
      slot.radius = world.definitions[i].shape->radius;
      slot.spin_speed = world.bodies[i].angular_velocity.norm() * slot.radius;
      slot.swept_bounds = present_bounds(world, i).expanded(sweep_margin(world, i, h));
      world.outgrown[i] = leaf_is_stale(world, i, h);
    }
  });
}

/// Moves the leaves that bodies have outgrown.
void refit_leaves(WorldState& world, Real h) {
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    if (!world.outgrown[i]) continue;
    move_leaf(world, static_cast<Index>(i), box_to_store(world, i, h));
  }
}

void mark_moved_bodies(WorldState& world) {
  world.has_moved.assign(world.slot_count(), 0);
  for (const Index body : world.moved) world.has_moved[body] = 1;
}

/// Whether the boxes of two bodies already overlapped when pairs were last searched for.
bool was_found(const WorldState& world, Index a, Index b) {
  return world.searched_bounds[a].overlaps(world.searched_bounds[b]);
}

/// Adds the keys of the pairs of a body that has moved whose boxes began to overlap.
void find_new_keys_of(const WorldState& world, Index body, PairSearch& search) {
  // Two bodies that have both moved find each other twice: only the smaller index counts.
  const auto counts = [&](Index other) {
    return other > body || (other < body && !world.has_moved[other]);
  };
  search.found.clear();
  world.tree.query(world.tree.bounds(world.slots[body].leaf), search.found);
  for (const Index other : search.found) {
    if (counts(other) && !was_found(world, body, other) && may_touch(world, body, other)) {
      search.keys.push_back(pair_key(body, other));
    }
  }
}

/// Searches for the pairs of all bodies that have moved, by several threads if there are any.
std::span<const PairSearch> search_for_pairs(WorldState& world) {
  constexpr std::size_t bodies_per_search = 32;
  const std::span<const Index> moved = world.moved;
  const std::size_t count = (moved.size() + bodies_per_search - 1) / bodies_per_search;
  if (world.searches.size() < count) world.searches.resize(count);
  for_blocks(world.team, count, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      PairSearch& search = world.searches[i];
      search.keys.clear();
      const std::size_t begin = i * bodies_per_search;
      for (const Index body :
           moved.subspan(begin, std::min(bodies_per_search, moved.size() - begin))) {
        if (world.slots[body].alive) find_new_keys_of(world, body, search);
      }
    }
  });
  return std::span(world.searches).first(count);
}

/// Sorted, each once. A few old ones may be among them: the boxes of a pair may part and meet again while its
/// bodies are at rest.
void find_new_keys(WorldState& world) {
  std::vector<std::uint64_t>& keys = world.new_keys;
  keys.clear();
  for (const PairSearch& search : search_for_pairs(world)) {
    keys.insert(keys.end(), search.keys.begin(), search.keys.end());
  }
  for (const Index body : world.moved) {
    if (!world.slots[body].alive) continue;
    world.searched_bounds[body] = world.tree.bounds(world.slots[body].leaf);
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// Whether the boxes of a pair no longer overlap.
bool has_ended(const WorldState& world, const PairSummary& pair) {
  if (!world.has_moved[pair.body_a] && !world.has_moved[pair.body_b]) return false;
  const BodySlot& a = world.slots[pair.body_a];
  const BodySlot& b = world.slots[pair.body_b];
  return !world.tree.bounds(a.leaf).overlaps(world.tree.bounds(b.leaf));
}

void combine_surfaces(WorldState& world, std::size_t pair) {
  Contact& contact = world.pairs.contacts[pair];
  const BodyDef& a = world.definitions[contact.body_a];
  const BodyDef& b = world.definitions[contact.body_b];
  contact.friction = std::sqrt(a.friction * b.friction);
  contact.restitution = std::max(a.restitution, b.restitution);
  world.pairs.summarise(pair);
}

void note_end(WorldState& world, std::size_t pair, std::vector<ContactEvent>& events) {
  if (!world.pairs.touching[pair]) return;
  const PairSummary& ended = world.pairs.summaries[pair];
  events.push_back({world.id_at(ended.body_a), world.id_at(ended.body_b)});
}

/// Drops the pairs whose boxes no longer overlap, and inserts the new ones; both are sorted.
void update_list(WorldState& world) {
  PairList& pairs = world.pairs;
  PairListEdit edit(pairs);
  auto key = world.new_keys.begin();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::uint64_t old_key = pair_key(pairs.summaries[i]);
    for (; key != world.new_keys.end() && *key < old_key; ++key) {
      edit.insert(i, *key);
    }
    if (key != world.new_keys.end() && *key == old_key) ++key;
    if (!has_ended(world, pairs.summaries[i])) continue;
    edit.drop(i);
    note_end(world, i, world.ended);
  }
  for (; key != world.new_keys.end(); ++key) edit.insert(pairs.size(), *key);
  edit.apply(world.team);
  for (const InsertedPair& pair : edit.inserted()) combine_surfaces(world, pair.to);
}

}  // namespace

Real spare_margin(const WorldState& world) { return 4 * world.slop(); }

Real closing_speed(const WorldState& world, Index body_a, Index body_b) {
  const RigidBody& a = world.bodies[body_a];
  const RigidBody& b = world.bodies[body_b];
  return (b.linear_velocity - a.linear_velocity).norm() + world.slots[body_a].spin_speed +
         world.slots[body_b].spin_speed;
}

Real contact_margin(const WorldState& world, Index body_a, Index body_b, Real h) {
  const Real closing = closing_speed(world, body_a, body_b);
  return spare_margin(world) + h * (closing + h * world.settings.gravity.norm());
}

void update_pairs(WorldState& world, Real h) {
  sweep_bounds(world, h);
  refit_leaves(world, h);
  if (world.moved.empty()) return;
  mark_moved_bodies(world);
  find_new_keys(world);
  update_list(world);
  world.moved.clear();
}

void insert_leaf(WorldState& world, Index body) {
  const PosedShape posed = world.posed_shape(body);
  world.bounds.resize(world.slot_count());
  world.bounds[body] = {posed.pose, world_bounds(posed)};
  const Bounds& bounds = world.bounds[body].bounds;
  world.slots[body].leaf = world.tree.insert(bounds.expanded(leaf_room(world)), body);
  world.moved.push_back(body);
  world.searched_bounds.resize(world.slot_count());
  world.searched_bounds[body] = {};
}

void enclose_bodies(WorldState& world) {
  world.outgrown.assign(world.slot_count(), 0);
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!is_awake(world, i) || world.bodies[i].kind == BodyKind::Static) continue;
      const Bounds& stored = world.tree.bounds(world.slots[i].leaf);
      world.outgrown[i] = !stored.contains(present_bounds(world, i));
    }
  });
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    if (!world.outgrown[i]) continue;
    move_leaf(world, static_cast<Index>(i), present_bounds(world, i).expanded(leaf_room(world)));
  }
}

void remove_pairs_of(WorldState& world, const std::vector<char>& bodies) {
  PairListEdit edit(world.pairs);
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    const PairSummary& pair = world.pairs.summaries[i];
    if (!bodies[pair.body_a] && !bodies[pair.body_b]) continue;
    edit.drop(i);
    note_end(world, i, world.ended_by_removal);
  }
  edit.apply();
}

}  // namespace cs550
