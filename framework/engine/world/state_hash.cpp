/// @file state_hash.cpp
/// A hash of everything in a world that one step leaves to the next.

#include <cstring>
#include <type_traits>

#include "cs550/world.hpp"
#include "engine/islands/sleeping.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

namespace {

/// Fowler–Noll–Vo hash, variant 1a. Members are added one by one, because the padding between them
/// has no defined value.
class Fnv1a {
 public:
  template <class Number>
  requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void add(Number number) {
    unsigned char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof bytes);
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3ULL;
  }
  template <int Rows, int Columns>
  void add(const Eigen::Matrix<Real, Rows, Columns, Eigen::DontAlign>& numbers) {
    for (const Real number : numbers.reshaped()) add(number);
  }
  void add(const Pose& pose) {
    add(pose.position);
    add(pose.orientation.coeffs());
  }
  void add(const Bounds& bounds) { add_all(bounds.lower, bounds.upper); }
  void add(const Plane& plane) { add_all(plane.normal, plane.offset); }

  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// The velocities of a dynamic body are derived from its momenta. Those of a kinematic body are state.
void add_state(Fnv1a& hash, const RigidBody& body) {
  hash.add(body.pose);
  hash.add_all(body.linear_momentum, body.angular_momentum, body.force, body.torque);
  if (body.kind == BodyKind::Kinematic) hash.add_all(body.linear_velocity, body.angular_velocity);
}

void add_manifold(Fnv1a& hash, const Manifold& manifold) {
  hash.add_all(manifold.normal, manifold.tangent, manifold.reference, manifold.points.size());
  for (const ContactPoint& point : manifold.points) {
    hash.add_all(point.anchor_a, point.anchor_b, point.separation, point.feature.bits,
                 point.normal_impulse, point.tangent_impulse);
  }
}

void add_face(Fnv1a& hash, const FaceQuery& query) {
  hash.add_all(query.face, query.vertex, query.separation);
}

/// The hint of the next step: the features that define the axis, and those faces that may replace edges.
void add_axis(Fnv1a& hash, const SeparatingAxis& axis) {
  hash.add_all(axis.feature, axis.separation);
  switch (axis.feature) {
    case AxisFeature::FaceA:
      hash.add_all(axis.face_a.face, axis.face_a.vertex);
      break;
    case AxisFeature::FaceB:
      hash.add_all(axis.face_b.face, axis.face_b.vertex);
      break;
    case AxisFeature::Edges:
      hash.add_all(axis.edges.edge_a, axis.edges.edge_b);
      add_face(hash, axis.face_a);
      add_face(hash, axis.face_b);
      break;
    case AxisFeature::None:
      break;
  }
}

void add_pair(Fnv1a& hash, const PairList& pairs, std::size_t i) {
  hash.add_all(pairs.contacts[i].body_a, pairs.contacts[i].body_b);
  add_manifold(hash, pairs.contacts[i].manifold);
  add_axis(hash, pairs.axes[i]);
  const PairMemory& memory = pairs.memories[i];
  hash.add_all(memory.smaller_in_larger, memory.margin, memory.plane, memory.tangent);
  hash.add_all(pairs.touching[i], pairs.impulse_energy[i], pairs.misplaced[i]);
}

void add_pairs(Fnv1a& hash, const PairList& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) add_pair(hash, pairs, i);
}

/// What decides when a body falls asleep, and which island it wakes with.
void add_rest(Fnv1a& hash, const BodyRest& rest) {
  hash.add_all(rest.start, rest.middle, rest.first_half, rest.time, rest.settled, rest.island);
}

void add_sleeping(Fnv1a& hash, const WorldState& world) {
  add_pairs(hash, world.sleeping.pairs);
  if (world.sleeping.pairs.size() > 0) hash.add(world.sleeping.substep_length);
  if (!world.settings.sleeping) return;  // the next step wakes all sleepers
  // If the settings differ, the next step wakes all sleepers, too.
  hash.add(move_alike(world.sleeping.settings, world.settings));
  for (std::size_t i = 0; i < world.sleeping.bodies.size(); ++i) {
    const BodyRest& rest = world.sleeping.bodies[i];
    add_rest(hash, rest);
    if (world.bodies[i].kind != BodyKind::Dynamic || rest.island != no_index) continue;
    const LeftBody& left = world.sleeping.left[i];
    hash.add_all(left.pose, left.linear_momentum, left.angular_momentum);
  }
}

/// What decides the solve order of the next step.
void add_parts(Fnv1a& hash, const BodyParts& parts) {
  if (parts.count == 1) return;
  hash.add_all(parts.count, parts.direction, parts.age);
  for (const Index part : parts.of_body) hash.add(part);
}

}  // namespace

std::uint64_t World::state_hash() const {
  Fnv1a hash;
  for (std::size_t i = 0; i < state_->slot_count(); ++i) {
    const BodySlot& slot = state_->slots[i];
    hash.add_all(slot.generation, slot.alive);
    if (!slot.alive) continue;
    add_state(hash, state_->bodies[i]);
    hash.add(state_->tree.bounds(slot.leaf));  // decides how long its pairs last
    if (state_->bodies[i].asleep) hash.add_all(slot.spin_speed, slot.swept_bounds);
  }
  add_pairs(hash, state_->pairs);
  add_sleeping(hash, *state_);
  add_parts(hash, state_->parts);
  for (const Index body : state_->moved) hash.add(body);
  for (const ContactEvent& event : state_->ended_by_removal) {
    hash.add_all(event.a.index, event.a.generation, event.b.index, event.b.generation);
  }
  hash.add(state_->substep_length);
  if (state_->settings.pass_order == PassOrder::StepByStep) hash.add(state_->step_count % 2);
  return hash.value();
}

}  // namespace cs550
