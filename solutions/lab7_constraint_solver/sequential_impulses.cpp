/// @file sequential_impulses.cpp
/// Lab 7, reference, L7.5 to L7.7 and L7.9: the impulses, one row after the other.

#include <algorithm>
#include <cmath>

#include "cs550/constraint_solver.hpp"
#include "cs550/naive_solver.hpp"

namespace cs550 {

namespace {

/// The velocity of B relative to A at the contact.
Vec3 relative_velocity(const ContactRow& row, const BodyVelocity& a, const BodyVelocity& b) {
  return b.v + b.w.cross(row.r_b) - a.v - a.w.cross(row.r_a);
}

/// The separation now: the row's own plus J times what the bodies have moved since the step began.
Real present_separation(const ContactRow& row, const BodyVelocity& a, const BodyVelocity& b) {
  const Vec3 moved = b.delta_position + b.delta_rotation.cross(row.r_b) - a.delta_position -
                     a.delta_rotation.cross(row.r_a);
  return row.separation + row.n.dot(moved);
}

void apply_pair(const ContactRow& row, const Vec3& impulse, BodyVelocity& a, BodyVelocity& b) {
  a.apply(-impulse, row.r_a);
  b.apply(impulse, row.r_b);
}

/// Adds to λ_n, keeps it from pulling, and applies what is left of the change.
void accumulate_normal(ContactRow& row, Real impulse, BodyVelocity& a, BodyVelocity& b) {
  const Real before = row.normal_impulse;
  row.normal_impulse = std::max(before + impulse, Real(0));
  apply_pair(row, (row.normal_impulse - before) * row.n, a, b);
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

bool bounces_now(const ContactRow& row, Real threshold) {
  return !row.struck && row.restitution > 0 && row.approach_velocity < -threshold;
}

/// Pushing, or about to: a few corners may stop a body before its other ones have closed their gaps.
bool is_in_touch(const ContactRow& row, Real separation, Real h) {
  return row.normal_impulse > 0 || separation < -2 * row.approach_velocity * h;
}

}  // namespace

void warm_start(const ContactRow& row, BodyVelocity& a, BodyVelocity& b) {
  const Vec3 impulse = row.normal_impulse * row.n + row.tangent_impulse.x() * row.u +
                       row.tangent_impulse.y() * row.v();
  apply_pair(row, impulse, a, b);
}

void solve_normal(ContactRow& row, BodyVelocity& a, BodyVelocity& b, const ContactStep& step) {
  const ContactBias bias = contact_bias(row, present_separation(row, a, b), step);
  const Real jv = row.n.dot(relative_velocity(row, a, b));
  const Real impulse = -bias.mass_scale * row.normal_mass * (jv + bias.velocity) -
                       bias.impulse_scale * row.normal_impulse;
  accumulate_normal(row, impulse, a, b);
}

void solve_friction(ContactRow& row, BodyVelocity& a, BodyVelocity& b) {
  const Vec3 v = row.v();
  const Vec3 relative = relative_velocity(row, a, b);
  const Vec2 slip(row.u.dot(relative), v.dot(relative));
  const Vec2 before = row.tangent_impulse;
  const Real limit = row.friction * row.normal_impulse;
  Vec2 impulse = before - row.tangent_mass * slip;
  if (impulse.norm() > limit) {
    impulse = scaled_onto_disk(before - smaller_eigenvalue(row.tangent_mass) * slip, limit);
  }
  row.tangent_impulse = impulse;
  const Vec2 change = impulse - before;
  apply_pair(row, change.x() * row.u + change.y() * v, a, b);
}

void apply_restitution(std::span<ContactRow> rows, std::span<BodyVelocity> bodies,
                       const ContactStep& step) {
  const auto body = [&](Index i) -> BodyVelocity& { return bodies[static_cast<std::size_t>(i)]; };
  const auto was_hit = [&](const ContactRow& row) {
    return row.normal_impulse > 0 && bounces_now(row, step.restitution_threshold);
  };
  const bool any = std::any_of(rows.begin(), rows.end(), was_hit);
  for (int sweep = 0; any && sweep < step.restitution_iterations; ++sweep) {
    for (ContactRow& row : rows) {
      BodyVelocity& a = body(row.body_a);
      BodyVelocity& b = body(row.body_b);
      if (!is_in_touch(row, present_separation(row, a, b), step.h)) continue;
      const bool bounce = bounces_now(row, step.restitution_threshold);
      const Real target = bounce ? -row.restitution * row.approach_velocity : 0;
      const Real v_n = normal_velocity(a, b, row.r_a, row.r_b, row.n);
      accumulate_normal(row, -row.normal_mass * (v_n - target), a, b);
    }
  }
  for (ContactRow& row : rows) row.struck = row.struck || row.normal_impulse > 0;
}

}  // namespace cs550
