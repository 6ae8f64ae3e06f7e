#include "engine/parts/part_numbering.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace cs550 {

namespace {

bool pays(const WorldState& world) {
  const SolveOrder& order = world.solve_order;
  return world.team != nullptr && order.units.size() > 1 && !order.contacts.empty() &&
         !world.any_bounces && !world.recovery.any && !world.settings.check_stages &&
         !world.settings.audit_momentum;
}

bool may_move(const RigidBody& body) { return body.kind != BodyKind::Static && !body.asleep; }

/// Whether the last numbers have each body that may move inside its part, whose thread then has it for itself. Bodies
/// are added, redefined and woken between the steps that divide them.
bool still_fit(std::span<const RigidBody> bodies, const BodyParts& parts) {
  if (parts.numbers.size() != bodies.size()) return false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Index part = parts.of_body[i];
    const bool inside =
        parts.first[part] <= parts.numbers[i] && parts.numbers[i] < parts.first[part + 1];
    if (may_move(bodies[i]) && !inside) return false;
  }
  return true;
}

/// Those that stay where they are come last, with the bodies of the last part.
void number_bodies(std::span<const RigidBody> bodies, BodyParts& parts) {
  if (still_fit(bodies, parts)) return;
  const auto group_of = [&](std::size_t body) {
    return may_move(bodies[body]) ? parts.of_body[body] : parts.count;
  };
  std::array<Index, most_parts + 2> next{};
  for (std::size_t i = 0; i < bodies.size(); ++i) ++next[group_of(i) + 1];
  for (std::size_t group = 1; group < next.size(); ++group) next[group] += next[group - 1];
  std::copy_n(next.begin(), parts.count, parts.first.begin());
  parts.first[parts.count] = static_cast<Index>(bodies.size());
  parts.numbers.resize(bodies.size());
  parts.bodies_by_number.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Index number = next[group_of(i)]++;
    parts.numbers[i] = number;
    parts.bodies_by_number[number] = static_cast<Index>(i);
  }
}

}  // namespace

PartNumbering::PartNumbering(WorldState& world) : world_(world) {
  if (!pays(world)) return;
  BodyParts& parts = world.parts;
  number_bodies(world.bodies, parts);
  parts.other_bodies.resize(world.bodies.size());
  parts.renumbered = true;
  std::atomic<bool> any_kinematic = false;
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const RigidBody& body = world.bodies[parts.bodies_by_number[i]];
      parts.other_bodies[i] = body;
      if (body.kind == BodyKind::Kinematic) any_kinematic.store(true, std::memory_order_relaxed);
    }
  });
  parts.any_kinematic = any_kinematic;
  std::swap(world.bodies, parts.other_bodies);
}

PartNumbering::~PartNumbering() {
  BodyParts& parts = world_.parts;
  if (!parts.renumbered) return;
  for_body_blocks(world_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      parts.other_bodies[parts.bodies_by_number[i]] = world_.bodies[i];
    }
  });
  std::swap(world_.bodies, parts.other_bodies);
  parts.renumbered = false;
}

}  // namespace cs550
