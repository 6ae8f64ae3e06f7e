#include <algorithm>
#include <utility>

#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

void begin_step(WorldState& world) {
  world.stats = {};
  world.problems.clear();
  world.began.clear();
  world.ended.clear();
  std::swap(world.ended, world.ended_by_removal);
  if (world.settings.check_stages) world.bodies_before = world.bodies;
}

void apply_gravity(WorldState& world) {
  for_dynamic_bodies(world,
                     [&](RigidBody& body) { body.force += body.mass * world.settings.gravity; });
}

void clear_forces(WorldState& world) {
  for (RigidBody& body : world.bodies) {
    body.force.setZero();
    body.torque.setZero();
  }
}

/// What the error is measured against: the momenta, and at rest the weight that acts in a step.
void audit_scale(WorldState& world, Real h) {
  double sum = 0;
  for_dynamic_bodies(world, [&](RigidBody& body) {
    sum += static_cast<double>(body.linear_momentum.norm());
    sum += static_cast<double>(body.mass * world.settings.gravity.norm() * h);
  });
  world.audit.largest_sum = std::max(world.audit.largest_sum, sum);
}

}  // namespace

void advance(WorldState& world, Real h) {
  begin_step(world);
  attempt(world, Stage::Integrate, [&] { for_moving_bodies(world, refresh_velocity); });
  detect_collisions(world, h);

  // The naive solver knows only separations as they were found: it gets one substep.
  const int substeps =
      world.settings.solver == SolverKind::Naive ? 1 : std::max(1, world.settings.substeps);
  const ContactStep step = contact_step(world.settings, h / static_cast<Real>(substeps));
  apply_gravity(world);
  bool with_contacts = attempt(world, Stage::Prepare, [&] { prepare(world, step); });
  if (!with_contacts) world.constraints.clear();
  for (int i = 0; i < substeps; ++i) substep(world, step, with_contacts);

  if (!with_contacts) drop_manifolds(world);
  store_impulses(world);
  clear_forces(world);
  if (world.settings.check_stages) check_bodies(world);
  if (world.settings.audit_momentum) audit_scale(world, h);
  attempt(world, Stage::BroadPhase, [&] { enclose_bodies(world); });
  ++world.step_count;
  world.time += static_cast<double>(h);
}

}  // namespace cs550
