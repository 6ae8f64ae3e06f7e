#include <algorithm>

#include "cs550/naive_solver.hpp"
#include "engine/body_sweeps.hpp"
#include "engine/contacts/contact_constraints.hpp"
#include "engine/contacts/contact_passes.hpp"
#include "engine/contacts/solve_order.hpp"
#include "engine/contacts/solver_bodies.hpp"
#include "engine/world/impact_energy.hpp"
#include "engine/world/overlap_recovery.hpp"
#include "engine/world/stages.hpp"
#include "engine/world/substep_passes.hpp"

namespace cs550 {

namespace {

/// v_n⁰, before this substep's gravity and warm start. It stays what it is once the impact is
/// handled.
void measure_approach(WorldState& world) {
  if (!world.any_bounces) return;
  read_back_impulses(world);
  for (ContactConstraint& constraint : world.constraints) {
    if (constraint.impact_handled || constraint.restitution == 0) continue;
    SolverBody a;
    SolverBody b;
    gather(world.bodies[constraint.body_a], a);
    gather(world.bodies[constraint.body_b], b);
    constraint.approach_velocity =
        normal_velocity(a, b, constraint.r_a, constraint.r_b, constraint.n);
  }
  world.mirrors.set_stale_numbers();
}

/// The naive solver starts from nothing, and so does the other one if the settings ask for it.
void forget_impulses(WorldState& world) {
  read_back_impulses(world);
  for (ContactConstraint& constraint : world.constraints) {
    constraint.normal_impulse = 0;
    constraint.tangent_impulse.setZero();
  }
  world.mirrors.set_stale_impulses();
}

/// The naive solver reflects the velocities that it finds, and these contain what gravity has added in this
/// step. A body would gain g·h with each bounce, and one at rest would begin to hop. Each restitution is
/// therefore reduced to what lets the contact part at e times v_n⁰.
void bounce_without_forces(std::span<ContactConstraint> constraints,
                           std::span<const SolverBody> bodies) {
  for (ContactConstraint& constraint : constraints) {
    if (constraint.restitution == 0) continue;
    const Real v_n = normal_velocity(bodies[constraint.body_a], bodies[constraint.body_b],
                                     constraint.r_a, constraint.r_b, constraint.n);
    const Real before = std::min(constraint.approach_velocity, Real(0));
    if (v_n < before) constraint.restitution *= before / v_n;
  }
}

/// The passes over the units of the solve order: the same as over all constraints in turn.
void run_passes_by_unit(WorldState& world, std::span<SolverBody> bodies, const ContactStep& step,
                        const Passes& passes) {
  const SolveOrder& order = world.solve_order;
  const auto run = [&](const Passes& some) {
    for_units_by_phase(world.team, order, some.backwards, [&](std::size_t i) {
      run_passes(world.mirrors.of_units[i], constraints_of(world, order.units[i]), bodies, step,
                 some);
    });
  };
  if (order.units.size() == 1 || passes.count == 0) {
    run(passes);
    return;
  }
  if (passes.warm_start) run({.warm_start = true, .store = false});
  for (int i = 0; i < passes.count; ++i) run(passes.one(i));
}

/// Passes of the chosen solver.
void solve(WorldState& world, std::span<SolverBody> bodies, const ContactStep& step,
           const Passes& passes) {
  if (world.settings.solver == SolverKind::Constraint) {
    run_passes_by_unit(world, bodies, step, passes);
    return;
  }
  if (world.any_bounces) bounce_without_forces(world.constraints, bodies);
  for (int pass = 0; pass < passes.count; ++pass) {
    resolve_contacts_naive(world.constraints, bodies);
  }
}

void resist_rolling(WorldState& world) {
  for_units_by_phase(world.team, world.solve_order, false,
                     [&](std::size_t unit) { resist_rolling(world, unit); });
}

/// A torque that rolling resistance balances must not turn a body at all, so the resistance acts before
/// the bodies move. It acts before the passes, too, so that these have the last word about velocities at
/// contacts. The loads are the impulses of the warm start.
void solve_with_bias(WorldState& world, const ContactStep& step) {
  const WorldSettings& settings = world.settings;
  world.impacts.any = is_soft(settings) && any_impact(world, step);
  if (world.impacts.any) note_energy_before_impacts(world);
  with_solver_bodies(world, [&](std::span<SolverBody> bodies) {
    refresh_masses(world, step);
    if (!starts_warm(settings)) forget_impulses(world);
    if (settings.solver == SolverKind::Constraint) begin_push(world);
    Passes passes = biased_passes(world, step);
    passes.warm_start = starts_warm(settings) && !resists_rolling(settings);
    if (resists_rolling(settings)) {
      solve(world, bodies, step, {.warm_start = true, .store = false});
      resist_rolling(world);
    }
    solve(world, bodies, step, passes);
  });
}

/// Removes the velocity that the bias has added.
void relax(WorldState& world, std::span<SolverBody> bodies, ContactStep step) {
  step.use_bias = false;
  solve(world, bodies, step, relax_passes(world));
}

/// Impacts bounce here if contacts are soft. The other models bounce in their passes.
void relax_and_bounce(WorldState& world, const ContactStep& step) {
  if (is_soft(world.settings)) {
    end_push(world);
    with_solver_bodies(world, [&](std::span<SolverBody> bodies) {
      refresh_masses_of_thin_bodies(world, step);
      if (world.impacts.any) begin_impacts(world, bodies);
      restart_after_push(world, bodies, step);
      relax(world, bodies, step);
      if (!world.any_bounces) return;
      read_back_impulses(world);
      apply_restitution(world.constraints, bodies, step);
      if (world.impacts.any) limit_impact_energy(world, bodies);
      world.mirrors.set_stale_impulses();
    });
  } else {
    read_back_impulses(world);
    if (world.settings.solver == SolverKind::Constraint) return_friction(world);
    // A contact bounces in one substep only.
    for (ContactConstraint& constraint : world.constraints) {
      constraint.mark_impact();
      if (constraint.impact_handled) constraint.approach_velocity = 0;
    }
    world.mirrors.set_stale_impulses();
  }
}

void apply_forces(WorldState& world, const ContactStep& step) {
  for_solver_body_blocks(world,
                         [&](std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies) {
                           integrate_momenta(bodies, step.h);
                           if (!world.constraints.empty()) gather(bodies, solver_bodies);
                         });
}

void move_bodies(WorldState& world, const ContactStep& step) {
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    const auto bodies = std::span(world.bodies).subspan(first, last - first);
    const auto solver_bodies = std::span(world.solver_bodies).subspan(first, last - first);
    integrate_poses(bodies, solver_bodies, step.h, world.settings.rotation);
    if (world.constraints.empty()) return;
    gather(bodies, solver_bodies);
    measure_turns(world, first, last, step.h);
  });
}

/// Runs a part of the substep that changes bodies, and checks them after it if the settings ask for
/// that.
template <class Part>
void run_checked(WorldState& world, Stage stage, const Part& part, const ContactStep& step) {
  run_stage(world, stage, part, step);
  if (!world.settings.check_stages) return;
  const int solver_lab = world.settings.solver == SolverKind::Naive ? 6 : 7;
  check_bodies(world, stage, stage == Stage::Integrate ? 1 : solver_lab);
}

}  // namespace

ContactStep contact_step(const WorldSettings& settings, Real h) {
  ContactStep step;
  step.h = h;
  step.model = settings.contact_model;
  // A spring that oscillates faster than the substeps can follow would shake.
  const Real hertz = std::min(settings.contact_hertz, Real(0.25) / h);
  step.soft = soft_contact(hertz, settings.contact_damping_ratio, h);
  step.soft_static = soft_contact(2 * hertz, settings.contact_damping_ratio / 2, h);
  step.baumgarte = settings.baumgarte;
  step.slop = settings.slop * settings.length_unit;
  step.max_push_speed = settings.max_push_speed * settings.length_unit;
  step.restitution_threshold = settings.restitution_threshold * settings.length_unit;
  step.restitution_iterations = settings.restitution_iterations;
  return step;
}

void prepare(WorldState& world, const ContactStep& step) {
  forget_turns(world);
  if (world.constraints.empty()) return;
  gather_solver_bodies(world);
  if (world.settings.solver == SolverKind::Naive) return make_constraints(world);
  keep_groups(world.solve_order, world.mirrors, world.team);
  world.cold_start.is_pair_cold.assign(world.pairs.size(), 0);
  for_groups_in_blocks(world,
                       [&](const ContactGroup& contacts, std::span<ContactConstraint> constraints) {
                         for (const Index contact : contacts) make_constraints(world, contact);
                         prepare_contacts(constraints, world.solver_bodies, step);
                         for (const Index contact : contacts) {
                           limit_carried_impulses(world, step, contact);
                           note_if_cold(world, contact, step.h);
                         }
                       });
  if (world.settings.warm_starting) guess_cold_impulses(world, step.h);
}

void substep(WorldState& world, const ContactStep& step) {
  run_stage(world, Stage::Solve, measure_approach);
  run_checked(world, Stage::Integrate, apply_forces, step);
  run_checked(world, Stage::Solve, solve_with_bias, step);
  run_checked(world, Stage::Integrate, move_bodies, step);
  run_checked(world, Stage::Solve, relax_and_bounce, step);
  audit_substep(world, step.h);
}

}  // namespace cs550
