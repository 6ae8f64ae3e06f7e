#include <algorithm>
#include <cmath>

#include "cs550/constraint_solver.hpp"
#include "cs550/integration.hpp"
#include "cs550/naive_solver.hpp"
#include "figure.hpp"

namespace cs550::book {
namespace {

SolverBody immovable() { return {}; }

/// A box of mass 1 that does not turn against the world's axes.
SolverBody free_body(const Vec3& half_extents) {
  const Vec3 squares = half_extents.cwiseProduct(half_extents);
  SolverBody body;
  body.inverse_mass = 1;
  body.world_inverse_inertia =
      (3 / (Vec3::Constant(squares.sum()) - squares).array()).matrix().asDiagonal();
  return body;
}

ContactConstraint constraint_between(Index a, Index b, const Vec3& n, const Vec3& r_a,
                                     const Vec3& r_b) {
  ContactConstraint constraint;
  constraint.body_a = a;
  constraint.body_b = b;
  constraint.n = n;
  constraint.u = any_perpendicular(n);
  constraint.r_a = r_a;
  constraint.r_b = r_b;
  return constraint;
}

ContactStep rigid_step() {
  ContactStep step;
  step.h = Real(1) / 60;
  step.use_bias = false;
  return step;
}

/// place of the blow over the length of the rod, effective mass over its mass: closed form, computed
void effective_mass_table(std::ostream& out) {
  SolverBody rod = free_body({Real(0.5), Real(0.001), Real(0.001)});
  for (int i = -20; i <= 20; ++i) {
    const double x = i / 40.0;
    const Vec3 place(static_cast<Real>(x), 0, 0);
    out << x << ' ' << 1 / (1 + 12 * x * x) << ' '
        << effective_mass(immovable(), rod, place, place, Vec3::UnitZ()) << '\n';
  }
}

/// time, distance of two cubes: right signs, the document's
void pulled(std::ostream& out) {
  double position[2] = {2, 2}, velocity[2] = {-1, -1};  // of B; A is as heavy and mirrors it
  for (int i = 0; i <= 180; ++i) {
    out << i / 60.0 << ' ' << 2 * position[0] - 2 << ' ' << 2 * position[1] - 2 << '\n';
    for (int k = 0; k < 2; ++k) {
      std::vector<SolverBody> bodies = {free_body(Vec3::Ones()), free_body(Vec3::Ones())};
      bodies[0].v.x() = static_cast<Real>(-velocity[k] / 2);
      bodies[1].v.x() = static_cast<Real>(velocity[k] / 2);
      std::vector<ContactConstraint> constraints = {
          constraint_between(0, 1, Vec3::UnitX(), Vec3::UnitX(), -Vec3::UnitX())};
      constraints[0].restitution = Real(0.5);
      constraints[0].separation = static_cast<Real>(2 * position[k] - 2);
      const Real before = bodies[1].v.x();
      resolve_contacts_naive(constraints, bodies);
      const Real change = bodies[1].v.x() - before;
      bodies[1].v.x() = before + (k == 0 ? change : -change);
      velocity[k] = static_cast<double>(2 * bodies[1].v.x());
      position[k] += velocity[k] / 2 / 60;
    }
  }
}

/// A plank that falls flat on two supports, both on one side of its middle.
struct Plank {
  std::vector<SolverBody> bodies = {immovable(), free_body({1, Real(0.01), Real(0.01)})};
  std::vector<ContactConstraint> constraints;

  Plank() {
    bodies[1].v.z() = -1;
    for (const Real x : {Real(1), Real(0.5)})
      constraints.push_back(constraint_between(0, 1, Vec3::UnitZ(), {x, 0, 0}, {x, 0, 0}));
    prepare_contacts(constraints, bodies, rigid_step());
  }
};

/// pass, impulse of the outer and inner support with the sum clamped, the same with the increment clamped
void accumulate(std::ostream& out) {
  Plank sum, increment;
  out << "0 0 0 0 0\n";
  for (int pass = 1; pass <= 20; ++pass) {
    for (ContactConstraint& constraint : sum.constraints)
      solve_normal(constraint, sum.bodies[0], sum.bodies[1], rigid_step());
    resolve_contacts_naive(increment.constraints, increment.bodies);
    out << pass;
    for (const Plank* plank : {&sum, &increment}) {
      for (const ContactConstraint& constraint : plank->constraints)
        out << ' ' << constraint.normal_impulse;
    }
    out << '\n';
  }
}

/// Boxes on each other, with the velocities that gravity gives them in a step.
struct Tower {
  std::vector<SolverBody> bodies = {immovable()};
  std::vector<ContactConstraint> constraints;

  explicit Tower(int height) {
    for (Index i = 1; i <= height; ++i) {
      bodies.push_back(free_body(Vec3::Constant(Real(0.5))));
      bodies.back().v.z() = Real(-9.81 / 60);
      for (const Real x : {Real(-0.5), Real(0.5)}) {
        for (const Real y : {Real(-0.5), Real(0.5)}) {
          constraints.push_back(
              constraint_between(i - 1, i, Vec3::UnitZ(), {x, y, Real(0.5)}, {x, y, Real(-0.5)}));
          constraints.back().friction = Real(0.6);
        }
      }
    }
    prepare_contacts(constraints, bodies, rigid_step());
  }

  /// The largest |JV| of the constraints that push, and the fastest approach of the others.
  double residual() const {
    double largest = 0;
    for (const ContactConstraint& constraint : constraints) {
      const auto& a = bodies[constraint.body_a];
      const auto& b = bodies[constraint.body_b];
      const auto v_n =
          static_cast<double>(normal_velocity(a, b, constraint.r_a, constraint.r_b, constraint.n));
      largest = std::max(largest, constraint.normal_impulse > 0 ? std::abs(v_n) : -v_n);
    }
    return largest;
  }
};

/// pass, residual: one direction, back and forth; the same for a tower half as high
void passes(std::ostream& out) {
  Tower tall[2] = {Tower(10), Tower(10)}, low[2] = {Tower(5), Tower(5)};
  ContactStep step = rigid_step();
  for (int pass = 0; pass <= 1000; ++pass) {
    out << pass << ' ' << tall[0].residual() << ' ' << tall[1].residual() << ' '
        << low[0].residual() << ' ' << low[1].residual() << '\n';
    for (Tower* towers : {tall, low}) {
      step.backwards = false;
      solve_contacts(towers[0].constraints, towers[0].bodies, step);
      step.backwards = pass % 2 == 1;
      solve_contacts(towers[1].constraints, towers[1].bodies, step);
    }
  }
}

/// A box that slides on a floor under its weight: one constraint at its middle.
double deceleration(double azimuth, bool in_a_box) {
  constexpr Real h = Real(1) / 60, mu = Real(0.5), weight = Real(9.81);
  std::vector<SolverBody> bodies = {immovable(), free_body(Vec3::Ones())};
  bodies[1].v = Vec3(static_cast<Real>(std::cos(azimuth)), static_cast<Real>(std::sin(azimuth)), 0);
  std::vector<ContactConstraint> constraints = {
      constraint_between(0, 1, Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero())};
  ContactConstraint& constraint = constraints[0];
  constraint.u = Vec3::UnitX();
  constraint.friction = mu;
  prepare_contacts(constraints, bodies, rigid_step());
  constraint.normal_impulse = weight * h;
  const Vec3 before = bodies[1].v;
  if (in_a_box) {
    const Real limit = mu * constraint.normal_impulse;
    for (int i = 0; i < 2; ++i) bodies[1].v[i] -= std::clamp(before[i], -limit, limit);
  } else {
    solve_friction(constraint, bodies[0], bodies[1]);
  }
  return static_cast<double>((bodies[1].v - before).norm() / (mu * weight * h));
}

/// direction (rad), deceleration over μg: each component limited, the disk
void friction_directions(std::ostream& out) {
  for (int i = 0; i <= 360; ++i) {
    const double azimuth = i * M_PI / 180;
    out << azimuth << ' ' << deceleration(azimuth, true) << ' ' << deceleration(azimuth, false)
        << '\n';
  }
}

/// What a bouncing contact asks for: the engine's bias, or the document's sum of push and bounce.
Real bias_of(ContactConstraint contact, const ContactStep& step, bool as_sum) {
  if (!as_sum) return contact_bias(contact, contact.separation, step).velocity;
  const Real bounce = contact.approach_velocity < -step.restitution_threshold
                          ? contact.restitution * contact.approach_velocity
                          : 0;
  contact.restitution = 0;
  return contact_bias(contact, contact.separation, step).velocity + bounce;
}

/// One step of a cube of 1 m above a floor at z = 0. Like the document's, its contact begins with the
/// overlap.
void fall_and_bounce(RigidBody& cube, const ContactStep& step, bool as_sum) {
  const Real approach = cube.linear_velocity.z();
  integrate_momentum(cube, step.h);
  refresh_velocity(cube);
  const Real gap = cube.pose.position.z() - Real(0.5);
  if (gap <= 0) {
    ContactConstraint contact =
        constraint_between(0, 1, Vec3::UnitZ(), Vec3::Zero(), {0, 0, Real(-0.5)});
    contact.separation = gap;
    contact.restitution = Real(0.8);
    contact.approach_velocity = approach;
    std::vector<SolverBody> bodies = {immovable(), free_body(Vec3::Constant(Real(0.5)))};
    prepare_contacts({&contact, 1}, bodies, step);
    const Real wanted = -bias_of(contact, step, as_sum);
    const Real impulse = contact.normal_mass * (wanted - cube.linear_velocity.z());
    apply_impulse(cube, {0, 0, std::max(impulse, Real(0))}, cube.pose.position);
  }
  integrate_pose(cube, step.h, RotationMethod::Explicit);
}

/// time, height of a cube that falls from 5 m: smaller of push and bounce, their sum
void bounce_sum(std::ostream& out) {
  constexpr int steps_per_second = 240;
  ContactStep step;
  step.h = Real(1) / steps_per_second;
  step.model = ContactModel::Baumgarte;
  step.slop = Real(1e-3);
  step.restitution_threshold = Real(0.5);
  const Mat3 inertia = Mat3::Identity() / 6;
  RigidBody cube = make_dynamic_body(1, inertia, {Vec3(0, 0, Real(5.5)), Quat::Identity()});
  add_force(cube, {0, 0, Real(-9.81)}, cube.pose.position);
  RigidBody cubes[] = {cube, cube};
  for (int i = 0; i <= 7 * steps_per_second; ++i) {
    out << static_cast<double>(i) / steps_per_second;
    for (const RigidBody& each : cubes) out << ' ' << each.pose.position.z() - Real(0.5);
    out << '\n';
    fall_and_bounce(cubes[0], step, false);
    fall_and_bounce(cubes[1], step, true);
  }
}

}  // namespace

std::vector<Table> solver_tables() {
  return {{"effective_mass", effective_mass_table},
          {"pulled", pulled},
          {"accumulate", accumulate},
          {"passes", passes},
          {"friction_directions", friction_directions},
          {"bounce_sum", bounce_sum}};
}

}  // namespace cs550::book
