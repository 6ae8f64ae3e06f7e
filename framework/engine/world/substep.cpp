#include <algorithm>

#include "cs550/naive_solver.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// v_n⁰ is measured before this substep's gravity and warm start, until the impact has been handled.
void measure_approach(WorldState& world) {
  for (ContactConstraint& constraint : world.constraints) {
    if (constraint.impact_handled || constraint.restitution == 0) continue;
    const SolverBody& a = world.velocities[static_cast<std::size_t>(constraint.body_a)];
    const SolverBody& b = world.velocities[static_cast<std::size_t>(constraint.body_b)];
    constraint.approach_velocity =
        normal_velocity(a, b, constraint.r_a, constraint.r_b, constraint.n);
  }
}

void warm_start_constraints(WorldState& world) {
  for (ContactConstraint& constraint : world.constraints) {
    if (!world.settings.warm_starting) {
      constraint.normal_impulse = 0;
      constraint.tangent_impulse.setZero();
      continue;
    }
    warm_start(constraint, world.velocities[static_cast<std::size_t>(constraint.body_a)],
               world.velocities[static_cast<std::size_t>(constraint.body_b)]);
  }
}

void mark_struck(WorldState& world) {
  for (ContactConstraint& constraint : world.constraints)
    constraint.impact_handled = constraint.impact_handled || constraint.normal_impulse > 0;
}

void solve_naive(WorldState& world) {
  for (ContactConstraint& constraint : world.constraints) constraint.normal_impulse = 0;
  for (int i = 0; i < world.settings.iterations; ++i) {
    resolve_contacts_naive(world.constraints, world.velocities);
  }
}

/// Passes of a substep go to and fro: two together are symmetric (see solve_contacts()).
bool goes_backwards(int pass) { return pass % 2 == 1; }

void solve(WorldState& world, ContactStep step) {
  gather_solver_bodies(world, world.velocities);
  if (world.settings.solver == SolverKind::Naive) {
    solve_naive(world);
  } else {
    refresh_masses(world, step);
    warm_start_constraints(world);
    step.use_bias = true;
    for (int i = 0; i < world.settings.iterations; ++i) {
      step.backwards = goes_backwards(i);
      solve_contacts(world.constraints, world.velocities, step);
    }
  }
  write_back_momenta(world);
}

/// Takes out the speed that the bias put in, then lets impacts bounce.
void relax(WorldState& world, ContactStep step) {
  const bool soft = world.settings.solver == SolverKind::Constraint &&
                    world.settings.contact_model == ContactModel::Soft;
  if (soft) {
    gather_solver_bodies(world, world.velocities);
    step.use_bias = false;
    for (int i = 0; i < world.settings.relax_iterations; ++i) {
      step.backwards = goes_backwards(world.settings.iterations + i);
      solve_contacts(world.constraints, world.velocities, step);
    }
    apply_restitution(world.constraints, world.velocities, step);
    write_back_momenta(world);
  } else {
    mark_struck(world);
  }
}

void move_bodies(WorldState& world, Real h) {
  for_moving_bodies(world,
                    [&](RigidBody& body) { turn_and_move(body, h, world.settings.rotation); });
}

/// What the bodies move in this substep is what separations change by. @pre before move_bodies()
void add_displacements(WorldState& world, Real h) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    world.velocities[i].delta_position += h * world.bodies[i].linear_velocity;
    world.velocities[i].delta_rotation += h * world.bodies[i].angular_velocity;
  }
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
  make_constraints(world);
  world.velocities.assign(world.bodies.size(), SolverBody{});
  gather_solver_bodies(world, world.velocities);
  if (world.settings.solver == SolverKind::Constraint) {
    prepare_contacts(world.constraints, world.velocities, step);
    if (world.settings.warm_starting) guess_cold_impulses(world, step.h);
  }
}

void substep(WorldState& world, const ContactStep& step, bool& with_contacts) {
  const Real h = step.h;
  const Eigen::Vector3d momentum_before =
      world.settings.audit_momentum ? total_momentum(world) : Eigen::Vector3d::Zero();

  with_contacts = with_contacts && attempt(world, Stage::Solve, [&] {
                    gather_solver_bodies(world, world.velocities);
                    measure_approach(world);
                  });
  attempt(world, Stage::Integrate, [&] {
    for_dynamic_bodies(world, [&](RigidBody& body) {
      integrate_momentum(body, h);
      refresh_velocity(body);
    });
  });
  with_contacts = with_contacts && attempt(world, Stage::Solve, [&] { solve(world, step); });
  attempt(world, Stage::Integrate, [&] {
    add_displacements(world, h);
    move_bodies(world, h);
  });
  with_contacts = with_contacts && attempt(world, Stage::Solve, [&] { relax(world, step); });
  if (!with_contacts) world.constraints.clear();

  if (world.settings.audit_momentum) {
    world.audit.unexplained += total_momentum(world) - momentum_before - outer_impulse(world, h);
  }
}

}  // namespace cs550
