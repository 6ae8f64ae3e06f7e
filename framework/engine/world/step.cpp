#include <algorithm>
#include <utility>

#include "engine/contacts/contact_constraints.hpp"
#include "engine/islands/sleeping.hpp"
#include "engine/pairs/near_pairs.hpp"
#include "engine/parts/part_numbering.hpp"
#include "engine/world/overlap_recovery.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

void begin_step(WorldState& world) {
  world.stats = {};
  world.problems.clear();
  world.unwritten.clear();
  world.began.clear();
  world.ended.clear();
  std::swap(world.ended, world.ended_by_removal);
  if (world.settings.check_stages) world.bodies_before = world.bodies;
}

void refresh_velocities(WorldState& world) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (RigidBody& body : std::span(world.bodies).subspan(first, last - first)) {
      if (!world.settings.sleeping) body.asleep = false;  // only the world puts a body to sleep
      if (body.kind == BodyKind::Static || body.asleep) {
        body.linear_velocity.setZero();  // which the program may have written
        body.angular_velocity.setZero();
      } else {
        refresh_velocity(body);
      }
    }
  });
}

void apply_gravity(WorldState& world) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (RigidBody& body : std::span(world.bodies).subspan(first, last - first)) {
      if (body.kind == BodyKind::Dynamic && !body.asleep)
        body.force += body.mass * world.settings.gravity;
    }
  });
}

/// The naive solver sees separations only as they are when the step begins, so it gets one substep.
int substep_count(const WorldSettings& settings) {
  return settings.solver == SolverKind::Naive ? 1 : settings.substeps;
}

void clear_forces(WorldState& world) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (RigidBody& body : std::span(world.bodies).subspan(first, last - first)) {
      body.force.setZero();
      body.torque.setZero();
    }
  });
}

void drop_contacts(WorldState& world) {
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    world.pairs.contacts[i].manifold.points.clear();
    world.pairs.summarise(i);
  }
  world.constraints.clear();
  // The rest of the step must not look for the constraints, nor the next one keep an order of them.
  world.solve_order = {};
  world.solve_order.first_point.assign(world.pairs.size() + 1, 0);
}

}  // namespace

void skip_stage(WorldState& world, Stage stage, const NotImplemented& missing) {
  world.unwritten.add(stage);
  if (stage != Stage::Integrate) drop_contacts(world);
  const auto is_same = [&](const StageProblem& known) { return known.message == missing.what(); };
  if (std::any_of(world.problems.begin(), world.problems.end(), is_same)) return;
  world.problems.push_back({stage, missing.lab(), no_index, world.step_count, missing.what()});
}

void advance(WorldState& world, Real h) {
  const int substeps = substep_count(world.settings);
  const ContactStep step = contact_step(world.settings, h / static_cast<Real>(substeps));
  begin_step(world);
  fit_impulses(world, step.h);
  wake_disturbed_bodies(world);
  run_stage(world, Stage::Integrate, refresh_velocities);
  detect_collisions(world, h);
  update_sleep(world);
  find_misplaced_bodies(world, h);

  run_stage(world, Stage::Prepare, arrange_contacts);
  {
    const PartNumbering numbering(world);
    apply_gravity(world);
    run_stage(world, Stage::Prepare, begin_constraints);
    begin_audit(world);
    run_substeps(world, step, substeps);
    end_audit(world, h);
    store_impulses(world);
    clear_forces(world);
  }
  report_touching(world);
  if (world.settings.check_stages) restore_broken_bodies(world);
  watch_rest(world, h);
  run_stage(world, Stage::BroadPhase, enclose_bodies);
  ++world.step_count;
  world.time += static_cast<double>(h);
}

}  // namespace cs550
