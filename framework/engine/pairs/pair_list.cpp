#include "engine/pairs/pair_list.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// Sorts like (a, b); a < b.
std::uint64_t pair_key(Index a, Index b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
         static_cast<std::uint64_t>(std::max(a, b));
}

std::uint64_t pair_key(const PairSummary& pair) { return pair_key(pair.body_a, pair.body_b); }

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

/// A leaf moves only if the swept bounds of its body leave the stored box, or if the box has become
/// far too large for a body that has slowed down.
bool leaf_is_stale(const Bounds& stored, const Bounds& swept_bounds, Real room) {
  return !stored.contains(swept_bounds) || !swept_bounds.expanded(4 * room).contains(stored);
}

/// Gives a body's leaf a new box and remembers to look for new pairs.
void move_leaf(WorldState& world, Index body, const Bounds& bounds) {
  world.tree.move(world.slots[body].leaf, bounds);
  world.moved.push_back(body);
}

/// How much larger than a body's swept bounds its stored box is (m).
Real leaf_room(const WorldState& world) { return Real(0.03) * world.settings.length_unit; }

/// How much larger than its shape's bounds a body's swept bounds are (m).
Real sweep_margin(const WorldState& world, std::size_t body, Real h) {
  const Real gravity = world.settings.gravity.norm();
  return 2 * world.slop() + travel(world.bodies[body], world.slots[body].spin_speed, gravity, h);
}

/// How much larger than a body's swept bounds a new box is that also leaves room for later steps (m).
Real swept_room(const WorldState& world, std::size_t body, Real h) {
  return leaf_room(world) + sweep_margin(world, body, h);
}

bool is_awake(const WorldState& world, std::size_t body) {
  return world.slots[body].alive && !world.bodies[body].asleep;
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
      slot.swept_bounds = world_bounds(world.posed_shape(static_cast<Index>(i)))
                              .expanded(sweep_margin(world, i, h));
      world.outgrown[i] =
          leaf_is_stale(world.tree.bounds(slot.leaf), slot.swept_bounds, swept_room(world, i, h));
    }
  });
}

/// Moves the leaves that bodies have outgrown.
void refit_leaves(WorldState& world, Real h) {
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    if (!world.outgrown[i]) continue;
    move_leaf(world, static_cast<Index>(i),
              world.slots[i].swept_bounds.expanded(swept_room(world, i, h)));
  }
}

/// Keys of the pairs whose boxes began to overlap, sorted, each once; old ones among them.
void find_new_keys(WorldState& world) {
  world.new_keys.clear();
  world.has_moved.assign(world.slot_count(), 0);
  for (const Index body : world.moved) world.has_moved[body] = 1;
  // Two bodies that have both moved find each other twice: only the smaller index counts.
  const auto counts = [&](Index body, Index other) {
    return other > body || (other < body && !world.has_moved[other]);
  };
  for (const Index body : world.moved) {
    if (!world.slots[body].alive) continue;
    world.found.clear();
    const Index leaf = world.slots[body].leaf;
    world.tree.query(world.tree.bounds(leaf), world.found);
    for (const Index other : world.found) {
      if (counts(body, other) && may_touch(world, body, other)) {
        world.new_keys.push_back(pair_key(body, other));
      }
    }
  }
  std::sort(world.new_keys.begin(), world.new_keys.end());
  world.new_keys.erase(std::unique(world.new_keys.begin(), world.new_keys.end()),
                       world.new_keys.end());
}

bool leaves_overlap(const WorldState& world, const PairSummary& pair) {
  const BodySlot& a = world.slots[pair.body_a];
  const BodySlot& b = world.slots[pair.body_b];
  return world.tree.bounds(a.leaf).overlaps(world.tree.bounds(b.leaf));
}

void append_new_pair(const WorldState& world, std::uint64_t key, PairList& pairs) {
  Contact contact;
  contact.body_a = static_cast<Index>(key >> 32);
  contact.body_b = static_cast<Index>(key & 0xffffffffU);
  const BodyDef& a = world.definitions[contact.body_a];
  const BodyDef& b = world.definitions[contact.body_b];
  contact.friction = std::sqrt(a.friction * b.friction);
  contact.restitution = std::max(a.restitution, b.restitution);
  pairs.append(contact);
}

void note_end(WorldState& world, std::size_t pair, std::vector<ContactEvent>& events) {
  if (!world.pairs.touching[pair]) return;
  const PairSummary& ended = world.pairs.summaries[pair];
  events.push_back({world.id_at(ended.body_a), world.id_at(ended.body_b)});
}

/// Merges the old pairs whose boxes still overlap with the new keys; both are sorted.
void merge_pairs(WorldState& world) {
  PairList& old = world.pairs;
  PairList& merged = world.next_pairs;
  merged.clear();
  merged.make_room(old.size() + world.new_keys.size());
  std::size_t appended = 0;  // of the old pairs, with those that have ended
  const auto append_up_to = [&](std::size_t i) {
    merged.append(old, appended, i);
    appended = i;
  };
  auto key = world.new_keys.begin();
  for (std::size_t i = 0; i < old.size(); ++i) {
    const std::uint64_t old_key = pair_key(old.summaries[i]);
    for (; key != world.new_keys.end() && *key < old_key; ++key) {
      append_up_to(i);
      append_new_pair(world, *key, merged);
    }
    if (key != world.new_keys.end() && *key == old_key) ++key;
    if (leaves_overlap(world, old.summaries[i])) continue;
    append_up_to(i);
    ++appended;
    note_end(world, i, world.ended);
  }
  append_up_to(old.size());
  for (; key != world.new_keys.end(); ++key) append_new_pair(world, *key, merged);
  std::swap(world.pairs, world.next_pairs);
}

}  // namespace

void PairList::summarise(std::size_t pair) {
  const Manifold& manifold = contacts[pair].manifold;
  PairSummary& summary = summaries[pair];
  summary.points = manifold.points.size();
  summary.depth = 0;
  for (const ContactPoint& point : manifold.points) {
    summary.depth = std::max(summary.depth, -point.separation);
  }
}

void PairList::clear() {
  contacts.clear();
  summaries.clear();
  axes.clear();
  memories.clear();
  answers.clear();
  touching.clear();
  impulse_energy.clear();
  misplaced.clear();
}

void PairList::make_room(std::size_t count) {
  if (count <= contacts.capacity()) return;
  const auto reserve = [&](auto&... arrays) { (arrays.reserve(2 * count), ...); };
  reserve(contacts, summaries, axes, memories, answers, touching, impulse_energy, misplaced);
}

void PairList::append(const Contact& contact) {
  contacts.push_back(contact);
  summaries.push_back({contact.body_a, contact.body_b});
  axes.emplace_back();
  memories.emplace_back();
  answers.push_back(PairAnswer::Queried);
  touching.push_back(0);
  impulse_energy.push_back(0);
  misplaced.push_back(0);
  summarise(size() - 1);
}

void PairList::append(const PairList& other, std::size_t first, std::size_t last) {
  const auto append_to = [&](auto& array, const auto& items) {
    array.insert(array.end(), items.begin() + static_cast<std::ptrdiff_t>(first),
                 items.begin() + static_cast<std::ptrdiff_t>(last));
  };
  append_to(contacts, other.contacts);
  append_to(summaries, other.summaries);
  append_to(axes, other.axes);
  append_to(memories, other.memories);
  append_to(answers, other.answers);
  append_to(touching, other.touching);
  append_to(impulse_energy, other.impulse_energy);
  append_to(misplaced, other.misplaced);
}

Real spare_margin(const WorldState& world) { return 4 * world.slop(); }

Real contact_margin(const WorldState& world, Index body_a, Index body_b, Real h) {
  const RigidBody& a = world.bodies[body_a];
  const RigidBody& b = world.bodies[body_b];
  const Real closing = (b.linear_velocity - a.linear_velocity).norm() +
                       world.slots[body_a].spin_speed + world.slots[body_b].spin_speed;
  return spare_margin(world) + h * (closing + h * world.settings.gravity.norm());
}

void update_pairs(WorldState& world, Real h) {
  sweep_bounds(world, h);
  refit_leaves(world, h);
  if (world.moved.empty()) return;
  find_new_keys(world);
  merge_pairs(world);
  world.moved.clear();
}

void insert_leaf(WorldState& world, Index body) {
  const Bounds bounds = world_bounds(world.posed_shape(body));
  world.slots[body].leaf = world.tree.insert(bounds.expanded(leaf_room(world)), body);
  world.moved.push_back(body);
}

void enclose_bodies(WorldState& world) {
  const auto bounds_of = [&](std::size_t body) {
    return world_bounds(world.posed_shape(static_cast<Index>(body)));
  };
  world.outgrown.assign(world.slot_count(), 0);
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!is_awake(world, i) || world.bodies[i].kind == BodyKind::Static) continue;
      world.outgrown[i] = !world.tree.bounds(world.slots[i].leaf).contains(bounds_of(i));
    }
  });
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    if (!world.outgrown[i]) continue;
    move_leaf(world, static_cast<Index>(i), bounds_of(i).expanded(leaf_room(world)));
  }
}

void move_pairs(PairList& from, PairList& to, PairList& scratch, const std::vector<char>& moves) {
  scratch.clear();
  scratch.make_room(from.size() + to.size());
  std::size_t in_to = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!moves[i]) continue;
    const std::uint64_t key = pair_key(from.summaries[i]);
    for (; in_to < to.size() && pair_key(to.summaries[in_to]) < key; ++in_to) {
      scratch.append(to, in_to);
    }
    scratch.append(from, i);
  }
  for (; in_to < to.size(); ++in_to) scratch.append(to, in_to);
  std::swap(to, scratch);

  scratch.clear();
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!moves[i]) scratch.append(from, i);
  }
  std::swap(from, scratch);
}

void remove_pairs_of(WorldState& world, Index body) {
  PairList& kept = world.next_pairs;
  kept.clear();
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    const PairSummary& pair = world.pairs.summaries[i];
    if (pair.body_a == body || pair.body_b == body) {
      note_end(world, i, world.ended_by_removal);
    } else {
      kept.append(world.pairs, i);
    }
  }
  std::swap(world.pairs, world.next_pairs);
}

}  // namespace cs550
