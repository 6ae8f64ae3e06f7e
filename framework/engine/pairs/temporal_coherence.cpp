#include "engine/pairs/temporal_coherence.hpp"

#include <algorithm>

#include "engine/pairs/displacement.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/pairs/relative_pose.hpp"

namespace cs550 {

namespace {

/// The pose of the body of smaller radius, seen from the other, and that radius. A body that turns moves
/// the points of a smaller one near it less than the other way round.
struct RelativePose {
  Pose smaller_in_larger;
  Real radius;
};

RelativePose relative_pose(const WorldState& world, const PairSummary& pair) {
  const Pose& a = world.bodies[pair.body_a].pose;
  const Pose& b = world.bodies[pair.body_b].pose;
  const Real radius_a = world.slots[pair.body_a].radius;
  const Real radius_b = world.slots[pair.body_b].radius;
  if (radius_b < radius_a) return {seen_from(a, b), radius_b};
  return {seen_from(b, a), radius_a};
}

}  // namespace

bool answer_holds(const WorldState& world, std::size_t pair, Real margin) {
  const SeparatingAxis& axis = world.pairs.axes[pair];
  if (axis.feature == AxisFeature::None) return false;

  const PairMemory& memory = world.pairs.memories[pair];
  const auto [now, radius] = relative_pose(world, world.pairs.summaries[pair]);
  const Real motion = largest_displacement(memory.smaller_in_larger, now, radius);
  if (!world.pairs.has_points(pair)) return axis.separation - motion > margin;

  const Real reach = margin - spare_margin(world);
  return motion <= kept_motion * radius && reach + motion <= memory.margin;
}

void remember_query(WorldState& world, std::size_t pair, Real margin) {
  PairMemory& memory = world.pairs.memories[pair];
  memory.margin = margin;
  memory.smaller_in_larger = relative_pose(world, world.pairs.summaries[pair]).smaller_in_larger;
}

void remember_plane(WorldState& world, std::size_t pair) {
  if (!world.pairs.has_points(pair)) return;
  PairMemory& memory = world.pairs.memories[pair];
  const Contact& contact = world.pairs.contacts[pair];
  const Manifold& manifold = contact.manifold;
  const bool on_b = manifold.reference == AxisFeature::FaceB;
  const Pose& owner = world.bodies[on_b ? contact.body_b : contact.body_a].pose;
  const ContactPoint& point = manifold.points[0];
  memory.plane.normal = owner.unrotate(manifold.normal);
  memory.plane.offset = memory.plane.normal.dot(on_b ? point.anchor_b : point.anchor_a);
  memory.tangent = owner.unrotate(manifold.tangent);
}

void move_manifold(WorldState& world, std::size_t pair) {
  Contact& contact = world.pairs.contacts[pair];
  const PairMemory& memory = world.pairs.memories[pair];
  Manifold& manifold = contact.manifold;
  const bool on_b = manifold.reference == AxisFeature::FaceB;
  const Pose& owner = world.bodies[on_b ? contact.body_b : contact.body_a].pose;
  const Pose& other = world.bodies[on_b ? contact.body_a : contact.body_b].pose;
  const Pose other_in_owner = seen_from(owner, other);
  const Real outward = on_b ? Real(-1) : Real(1);  // the normal points from A to B

  manifold.normal = owner.rotate(memory.plane.normal);
  manifold.tangent = owner.rotate(memory.tangent);
  for (ContactPoint& point : manifold.points) {
    const Vec3 on_other = other_in_owner.to_world(on_b ? point.anchor_a : point.anchor_b);
    const Real height = memory.plane.distance(on_other);
    (on_b ? point.anchor_b : point.anchor_a) = on_other - height * memory.plane.normal;
    point.separation = outward * height;
    if (!world.settings.warm_starting) {
      point.normal_impulse = 0;
      point.tangent_impulse = {0, 0};
    }
  }
}

}  // namespace cs550
