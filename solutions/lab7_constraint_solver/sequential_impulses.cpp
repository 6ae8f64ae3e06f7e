/// @file sequential_impulses.cpp
/// Lab 7, reference, L7.5 to L7.9: the impulses, one constraint after the other.

#include <algorithm>
#include <cmath>

#include "cs550/constraint_solver.hpp"
#include "cs550/naive_solver.hpp"

namespace cs550 {

namespace {

/// The velocity of B relative to A at the contact.
Vec3 relative_velocity(const ContactConstraint& constraint, const SolverBody& a,
                       const SolverBody& b) {
  return b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a);
}

/// The separation now: the constraint's own plus J times what the bodies have moved since the step began.
Real present_separation(const ContactConstraint& constraint, const SolverBody& a,
                        const SolverBody& b) {
  const Vec3 moved = b.delta_position + b.delta_rotation.cross(constraint.r_b) - a.delta_position -
                     a.delta_rotation.cross(constraint.r_a);
  return constraint.separation + constraint.n.dot(moved);
}

void apply_pair(const ContactConstraint& constraint, const Vec3& impulse, SolverBody& a,
                SolverBody& b) {
  a.apply(-impulse, constraint.r_a);
  b.apply(impulse, constraint.r_b);
}

/// Adds to λ_n, keeps it from pulling, and applies what is left of the change.
void accumulate_normal(ContactConstraint& constraint, Real impulse, SolverBody& a, SolverBody& b) {
  const Real before = constraint.normal_impulse;
  constraint.normal_impulse = std::max(before + impulse, Real(0));
  apply_pair(constraint, (constraint.normal_impulse - before) * constraint.n, a, b);
}

Vec2 scaled_onto_disk(const Vec2& impulse, Real radius) {
  const Real length = impulse.norm();
  return length > radius ? Vec2(radius / length * impulse) : impulse;
}

/// Of a symmetric 2 × 2 matrix: half the trace less the root of the discriminant.
Real smaller_eigenvalue(const Mat2& m) {
  const Real half_trace = Real(0.5) * m.trace();
  return half_trace - std::sqrt(std::max(Real(0), half_trace * half_trace - m.determinant()));
}

bool bounces_now(const ContactConstraint& constraint, Real threshold) {
  return !constraint.impact_handled && constraint.restitution > 0 &&
         constraint.approach_velocity < -threshold;
}

/// Pushing, or about to: a few corners may stop a body before its other ones have closed their gaps.
bool is_in_touch(const ContactConstraint& constraint, Real separation, Real h) {
  return constraint.normal_impulse > 0 || separation < -2 * constraint.approach_velocity * h;
}

}  // namespace

void warm_start(const ContactConstraint& constraint, SolverBody& a, SolverBody& b) {
  const Vec3 impulse = constraint.normal_impulse * constraint.n +
                       constraint.tangent_impulse.x() * constraint.u +
                       constraint.tangent_impulse.y() * constraint.v();
  apply_pair(constraint, impulse, a, b);
}

void solve_normal(ContactConstraint& constraint, SolverBody& a, SolverBody& b,
                  const ContactStep& step) {
  const ContactBias bias = contact_bias(constraint, present_separation(constraint, a, b), step);
  const Real jv = constraint.n.dot(relative_velocity(constraint, a, b));
  const Real impulse = -bias.mass_scale * constraint.normal_mass * (jv + bias.velocity) -
                       bias.impulse_scale * constraint.normal_impulse;
  accumulate_normal(constraint, impulse, a, b);
}

void solve_friction(ContactConstraint& constraint, SolverBody& a, SolverBody& b) {
  const Vec3 v = constraint.v();
  const Vec3 relative = relative_velocity(constraint, a, b);
  const Vec2 slip(constraint.u.dot(relative), v.dot(relative));
  const Vec2 before = constraint.tangent_impulse;
  const Real limit = constraint.friction * constraint.normal_impulse;
  Vec2 impulse = before - constraint.tangent_mass * slip;
  if (impulse.norm() > limit) {
    impulse = scaled_onto_disk(before - smaller_eigenvalue(constraint.tangent_mass) * slip, limit);
  }
  constraint.tangent_impulse = impulse;
  const Vec2 change = impulse - before;
  apply_pair(constraint, change.x() * constraint.u + change.y() * v, a, b);
}

void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step) {
  const auto body = [&](Index i) -> SolverBody& { return bodies[i]; };
  if (step.backwards) {
    for (auto constraint = constraints.rbegin(); constraint != constraints.rend(); ++constraint) {
      solve_friction(*constraint, body(constraint->body_a), body(constraint->body_b));
      solve_normal(*constraint, body(constraint->body_a), body(constraint->body_b), step);
    }
  } else {
    for (ContactConstraint& constraint : constraints) {
      solve_normal(constraint, body(constraint.body_a), body(constraint.body_b), step);
      solve_friction(constraint, body(constraint.body_a), body(constraint.body_b));
    }
  }
}

void apply_restitution(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                       const ContactStep& step) {
  const auto body = [&](Index i) -> SolverBody& { return bodies[i]; };
  const auto was_hit = [&](const ContactConstraint& constraint) {
    return constraint.normal_impulse > 0 && bounces_now(constraint, step.restitution_threshold);
  };
  const bool any = std::any_of(constraints.begin(), constraints.end(), was_hit);
  for (int sweep = 0; any && sweep < step.restitution_iterations; ++sweep) {
    for (ContactConstraint& constraint : constraints) {
      SolverBody& a = body(constraint.body_a);
      SolverBody& b = body(constraint.body_b);
      if (!is_in_touch(constraint, present_separation(constraint, a, b), step.h)) continue;
      const bool bounce = bounces_now(constraint, step.restitution_threshold);
      const Real target = bounce ? -constraint.restitution * constraint.approach_velocity : 0;
      const Real v_n = normal_velocity(a, b, constraint.r_a, constraint.r_b, constraint.n);
      accumulate_normal(constraint, -constraint.normal_mass * (v_n - target), a, b);
    }
  }
  for (ContactConstraint& constraint : constraints) constraint.mark_impact();
}

}  // namespace cs550
