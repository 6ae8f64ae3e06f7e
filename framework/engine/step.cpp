#include <algorithm>
#include <chrono>

#include "cs550/clipping.hpp"
#include "cs550/naive_solver.hpp"
#include "cs550/not_implemented.hpp"
#include "world_state.hpp"

namespace cs550 {

namespace {

/// Adds the time until its end of life to a stage's account.
class StageTimer {
 public:
  StageTimer(StepStats& stats, Stage stage)
      : seconds_(stats.seconds[static_cast<std::size_t>(stage)]), start_(Clock::now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_;
};

/// Runs a stage; one that is not written yet is reported once per step, and the step goes on.
template <class Run>
bool attempt(WorldState& world, Stage stage, Run run) {
  const StageTimer timer(world.stats, stage);
  try {
    run();
    return true;
  } catch (const NotImplemented& missing) {
    const auto same = [&](const StageProblem& known) { return known.message == missing.what(); };
    if (std::none_of(world.problems.begin(), world.problems.end(), same)) {
      world.problems.push_back({stage, missing.lab(), no_index, world.step_count, missing.what()});
    }
    return false;
  }
}

template <class Visit>
void for_dynamic_bodies(WorldState& world, Visit visit) {
  for (RigidBody& body : world.bodies) {
    if (body.kind == BodyKind::Dynamic) visit(body);
  }
}

template <class Visit>
void for_moving_bodies(WorldState& world, Visit visit) {
  for (RigidBody& body : world.bodies) {
    if (body.kind != BodyKind::Static) visit(body);
  }
}

void apply_gravity(WorldState& world) {
  for_dynamic_bodies(world,
                     [&](RigidBody& body) { body.force += body.mass * world.settings.gravity; });
}

void find_axes(WorldState& world, Real h) {
  PairList& pairs = world.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Contact& contact = pairs.contacts[i];
    const Bounds& reach_a = world.slots[static_cast<std::size_t>(contact.body_a)].reach;
    const Bounds& reach_b = world.slots[static_cast<std::size_t>(contact.body_b)].reach;
    if (!reach_a.overlaps(reach_b)) {
      pairs.axes[i].feature = AxisFeature::None;
      continue;
    }
    const Real margin = contact_margin(world, contact.body_a, contact.body_b, h);
    pairs.axes[i] = find_separating_axis(world.posed_shape(contact.body_a),
                                         world.posed_shape(contact.body_b), pairs.axes[i], margin);
  }
}

void build_manifolds(WorldState& world, Real h) {
  PairList& pairs = world.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Contact& contact = pairs.contacts[i];
    const SeparatingAxis& axis = pairs.axes[i];
    const Real margin = contact_margin(world, contact.body_a, contact.body_b, h);
    if (axis.feature == AxisFeature::None || axis.separation > margin) {
      contact.manifold.points.clear();
      continue;
    }
    const Manifold before = contact.manifold;
    contact.manifold = build_manifold(world.posed_shape(contact.body_a),
                                      world.posed_shape(contact.body_b), axis, margin);
    if (world.settings.warm_starting) carry_impulses(before, contact.manifold);
  }
}

void drop_manifolds(WorldState& world) {
  for (Contact& contact : world.pairs.contacts) contact.manifold.points.clear();
}

void detect_collisions(WorldState& world, Real h) {
  attempt(world, Stage::BroadPhase, [&] { update_pairs(world, h); });
  bool done = attempt(world, Stage::Collide, [&] { find_axes(world, h); });
  if (done && world.settings.check_stages) check_axes(world);
  done = done && attempt(world, Stage::Manifolds, [&] { build_manifolds(world, h); });
  if (!done) drop_manifolds(world);
  if (done && world.settings.check_stages) check_manifolds(world);
}

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
  fill_rows(world);
  world.velocities.assign(world.bodies.size(), BodyVelocity{});
  gather_velocities(world, world.velocities);
  if (world.settings.solver == SolverKind::Constraint) {
    prepare_contacts(world.rows, world.velocities, step);
    if (world.settings.warm_starting) guess_cold_impulses(world, step.h);
  }
}

/// v_n⁰ is measured before this substep's gravity and warm start, until the row has struck.
void measure_approach(WorldState& world) {
  for (ContactRow& row : world.rows) {
    if (row.struck || row.restitution == 0) continue;
    const BodyVelocity& a = world.velocities[static_cast<std::size_t>(row.body_a)];
    const BodyVelocity& b = world.velocities[static_cast<std::size_t>(row.body_b)];
    row.approach_velocity = normal_velocity(a, b, row.r_a, row.r_b, row.n);
  }
}

void warm_start_rows(WorldState& world) {
  for (ContactRow& row : world.rows) {
    if (!world.settings.warm_starting) {
      row.normal_impulse = 0;
      row.tangent_impulse.setZero();
      continue;
    }
    warm_start(row, world.velocities[static_cast<std::size_t>(row.body_a)],
               world.velocities[static_cast<std::size_t>(row.body_b)]);
  }
}

void mark_struck(WorldState& world) {
  for (ContactRow& row : world.rows) row.struck = row.struck || row.normal_impulse > 0;
}

void solve_naive(WorldState& world) {
  for (ContactRow& row : world.rows) row.normal_impulse = 0;
  for (int i = 0; i < world.settings.iterations; ++i) {
    resolve_contacts_naive(world.rows, world.velocities);
  }
}

/// Passes of a substep go to and fro: two together are symmetric (see solve_contacts()).
bool goes_backwards(int pass) { return pass % 2 == 1; }

void solve(WorldState& world, ContactStep step) {
  gather_velocities(world, world.velocities);
  if (world.settings.solver == SolverKind::Naive) {
    solve_naive(world);
  } else {
    refresh_masses(world, step);
    warm_start_rows(world);
    step.use_bias = true;
    for (int i = 0; i < world.settings.iterations; ++i) {
      step.backwards = goes_backwards(i);
      solve_contacts(world.rows, world.velocities, step);
    }
  }
  write_back_momenta(world);
}

/// Takes out the speed that the bias put in, then lets impacts bounce.
void relax(WorldState& world, ContactStep step) {
  const bool soft = world.settings.solver == SolverKind::Constraint &&
                    world.settings.contact_model == ContactModel::Soft;
  if (soft) {
    gather_velocities(world, world.velocities);
    step.use_bias = false;
    for (int i = 0; i < world.settings.relax_iterations; ++i) {
      step.backwards = goes_backwards(world.settings.iterations + i);
      solve_contacts(world.rows, world.velocities, step);
    }
    apply_restitution(world.rows, world.velocities, step);
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

void substep(WorldState& world, const ContactStep& step, bool& with_contacts) {
  const Real h = step.h;
  const Eigen::Vector3d momentum_before =
      world.settings.audit_momentum ? total_momentum(world) : Eigen::Vector3d::Zero();

  with_contacts = with_contacts && attempt(world, Stage::Solve, [&] {
                    gather_velocities(world, world.velocities);
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
  if (!with_contacts) world.rows.clear();

  if (world.settings.audit_momentum) {
    world.ledger.unexplained += total_momentum(world) - momentum_before - outer_impulse(world, h);
  }
}

/// What the error is measured against: the momenta, and at rest the weight that acts in a step.
void audit_scale(WorldState& world, Real h) {
  double sum = 0;
  for_dynamic_bodies(world, [&](RigidBody& body) {
    sum += static_cast<double>(body.linear_momentum.norm());
    sum += static_cast<double>(body.mass * world.settings.gravity.norm() * h);
  });
  world.ledger.largest_sum = std::max(world.ledger.largest_sum, sum);
}

void count_contacts(WorldState& world) {
  StepStats& stats = world.stats;
  stats.pairs = static_cast<int>(world.pairs.size());
  for (const Contact& contact : world.pairs.contacts) {
    if (!contact.manifold.points.empty()) ++stats.contacts;
    stats.points += contact.manifold.points.size();
    for (const ContactPoint& point : contact.manifold.points) {
      stats.deepest_separation = std::min(stats.deepest_separation, point.separation);
    }
  }
}

void begin_step(WorldState& world) {
  world.stats = {};
  world.problems.clear();
  world.began.clear();
  world.ended.clear();
  std::swap(world.ended, world.ended_by_removal);
  if (world.settings.check_stages) world.bodies_before = world.bodies;
}

}  // namespace

void advance(WorldState& world, Real h) {
  begin_step(world);
  attempt(world, Stage::Integrate, [&] { for_moving_bodies(world, refresh_velocity); });
  detect_collisions(world, h);
  count_contacts(world);

  // The naive solver knows only separations as they were found: it gets one substep.
  const int substeps =
      world.settings.solver == SolverKind::Naive ? 1 : std::max(1, world.settings.substeps);
  const ContactStep step = contact_step(world.settings, h / static_cast<Real>(substeps));
  apply_gravity(world);
  bool with_contacts = attempt(world, Stage::Prepare, [&] { prepare(world, step); });
  if (!with_contacts) world.rows.clear();
  for (int i = 0; i < substeps; ++i) substep(world, step, with_contacts);

  if (!with_contacts) drop_manifolds(world);
  store_impulses(world);
  for (RigidBody& body : world.bodies) {
    body.force.setZero();
    body.torque.setZero();
  }
  if (world.settings.check_stages) check_bodies(world);
  if (world.settings.audit_momentum) audit_scale(world, h);
  attempt(world, Stage::BroadPhase, [&] { enclose_bodies(world); });
  ++world.step_count;
  world.time += static_cast<double>(h);
}

}  // namespace cs550
