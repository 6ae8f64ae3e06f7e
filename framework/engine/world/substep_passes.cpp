#include "engine/world/substep_passes.hpp"

#include <algorithm>

#include "engine/contacts/rolling_resistance.hpp"

namespace cs550 {

namespace {

/// `count` passes of a substep, after `done` of them.
Passes passes_after(const WorldState& world, int done, int count) {
  Passes passes;
  passes.count = count;
  passes.store = false;  // see read_back_impulses()
  passes.alternate = world.settings.pass_order == PassOrder::BackAndForth;
  // Without passes only the warm start is left, and that always goes forwards.
  passes.backwards = count > 0 && (passes.alternate ? done : world.step_count) % 2 == 1;
  return passes;
}

}  // namespace

bool is_soft(const WorldSettings& settings) {
  return settings.solver == SolverKind::Constraint && settings.contact_model == ContactModel::Soft;
}

bool starts_warm(const WorldSettings& settings) {
  return settings.warm_starting && settings.solver == SolverKind::Constraint;
}

bool resists_rolling(const WorldSettings& settings) {
  return starts_warm(settings) && is_soft(settings) && settings.rolling_resistance > 0;
}

void resist_rolling(WorldState& world, std::size_t unit) {
  const Real lever = world.settings.rolling_resistance * world.settings.length_unit;
  resist_rolling(world.mirrors.of_units[unit], world.solve_order, world.constraints,
                 world.solver_bodies, lever);
}

bool any_impact(const WorldState& world, const ContactStep& step) {
  const auto is_impact = [&](const ContactConstraint& constraint) {
    return !constraint.impact_handled && constraint.restitution > 0 &&
           constraint.approach_velocity < -step.restitution_threshold;
  };
  return world.any_bounces &&
         std::any_of(world.constraints.begin(), world.constraints.end(), is_impact);
}

/// Where passes bounce, a single one gives each corner of a body its own speed on top of what the other
/// corners gave, which is more energy than there was.
Passes biased_passes(const WorldState& world, const ContactStep& step) {
  const WorldSettings& settings = world.settings;
  Passes passes = passes_after(world, 0, settings.iterations);
  const bool passes_bounce = settings.solver == SolverKind::Constraint &&
                             settings.contact_model == ContactModel::Baumgarte;
  if (passes.count > 0 && passes_bounce && any_impact(world, step)) {
    passes.count = std::max(passes.count, settings.restitution_iterations);
  }
  return passes;
}

/// Restitution drives only contacts that push. A blow must therefore load a whole row of touching bodies
/// before it, and a pass against the order of the row carries it by one body only.
///
/// Where nothing bounces, the marks are all that apply_restitution() would leave.
Passes relax_passes(const WorldState& world) {
  const WorldSettings& settings = world.settings;
  Passes passes = passes_after(world, settings.iterations, settings.relax_iterations);
  passes.mark_impacts = !world.any_bounces;
  if (!world.impacts.any) {
    passes.over_relaxation = settings.over_relaxation;
  } else if (passes.count > 0) {
    passes.count = std::max(passes.count, 2);
    passes.alternate = true;
  }
  return passes;
}

}  // namespace cs550
