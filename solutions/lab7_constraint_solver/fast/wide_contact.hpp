#pragma once
/// @file wide_contact.hpp
/// L7.5 to L7.7 for eight contacts at a time, each lane with the bits of the teaching form.

#include "cs550/constraint_solver.hpp"
#include "wide_body.hpp"
#include "wide_constraint.hpp"

namespace cs550::CS550_LANES {

/// The bodies of a row of constraints.
struct WidePair {
  WideBody a, b;

  void apply(const WideConstraint& constraint, const WideVec3& impulse) {
    a.apply(-impulse, constraint.r_a);
    b.apply(impulse, constraint.r_b);
  }
  WideVec3 relative_velocity(const WideConstraint& constraint) const {
    return b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a);
  }
  WideReal separation(const WideConstraint& constraint) const {
    const WideVec3 moved = b.delta_position + b.delta_rotation.cross(constraint.r_b) -
                           a.delta_position - a.delta_rotation.cross(constraint.r_a);
    return constraint.separation + constraint.n.dot(moved);
  }
};

/// warm_start(). The constraint remembers whether it has a load.
inline void warm_start(WideConstraint& constraint, WidePair& pair) {
  const WideVec3 impulse = constraint.normal_impulse * constraint.n +
                           constraint.tangent_u * constraint.u +
                           constraint.tangent_v * constraint.n.cross(constraint.u);
  pair.apply(constraint, impulse);
  mark_loads(constraint);
}

struct WideBias {
  WideReal velocity, mass_scale, impulse_scale;
};

/// contact_bias().
inline WideBias contact_bias(const WideConstraint& constraint, WideReal separation,
                             const ContactStep& step) {
  const WideReal zero = all_lanes(0);
  const WideReal fastest = all_lanes(-step.max_push_speed);
  WideBias touching{zero, all_lanes(1), zero};
  if (step.use_bias && step.model == ContactModel::Soft) {
    touching.velocity = larger(constraint.bias_rate * separation, fastest);
    touching.mass_scale = constraint.mass_scale;
    touching.impulse_scale = constraint.impulse_scale;
  } else if (step.use_bias) {
    const WideReal excess = smaller(separation + all_lanes(step.slop), zero);
    touching.velocity = larger(all_lanes(step.baumgarte / step.h) * excess, fastest);
  }
  const WideMask apart = separation > zero;
  WideBias bias;
  bias.velocity = select(apart, separation / all_lanes(step.h), touching.velocity);
  bias.mass_scale = select(apart, all_lanes(1), touching.mass_scale);
  bias.impulse_scale = select(apart, zero, touching.impulse_scale);
  if (step.use_bias && step.model == ContactModel::Baumgarte) {
    const WideMask bounces =
        (constraint.restitution > zero) &
        (constraint.approach_velocity < all_lanes(-step.restitution_threshold));
    const WideReal bounce = constraint.restitution * constraint.approach_velocity;
    bias.velocity = select(bounces, smaller(bias.velocity, bounce), bias.velocity);
  }
  return bias;
}

/// normal_mass, as over-relaxation multiplies it.
inline WideReal relaxed_mass(const WideConstraint& constraint, Real over_relaxation) {
  if (over_relaxation == 1) return constraint.normal_mass;
  return select(has(constraint.flags, loaded_bit),
                constraint.normal_mass * all_lanes(over_relaxation), constraint.normal_mass);
}

/// solve_normal().
inline void solve_normal(WideConstraint& constraint, WidePair& pair, const ContactStep& step,
                         Real over_relaxation) {
  const WideBias bias = contact_bias(constraint, pair.separation(constraint), step);
  const WideReal jv = constraint.n.dot(pair.relative_velocity(constraint));
  const WideReal mass = relaxed_mass(constraint, over_relaxation);
  const WideReal impulse = -bias.mass_scale * mass * (jv + bias.velocity) -
                           bias.impulse_scale * constraint.normal_impulse;
  const WideReal before = constraint.normal_impulse;
  constraint.normal_impulse = larger(before + impulse, all_lanes(0));
  pair.apply(constraint, (constraint.normal_impulse - before) * constraint.n);
}

/// The smaller eigenvalue of tangent_mass.
inline WideReal sliding_mass(const WideConstraint& constraint) {
  const WideMat2& m = constraint.tangent_mass;
  const WideReal half_trace = all_lanes(Real(0.5)) * (m.uu + m.vv);
  const WideReal determinant = m.uu * m.vv - m.vu * m.uv;
  return half_trace - square_root(larger(all_lanes(0), half_trace * half_trace - determinant));
}

/// solve_friction().
inline void solve_friction(WideConstraint& constraint, WidePair& pair) {
  const WideVec3 v = constraint.n.cross(constraint.u);
  const WideVec3 relative = pair.relative_velocity(constraint);
  const WideReal slip_u = constraint.u.dot(relative);
  const WideReal slip_v = v.dot(relative);
  const WideReal before_u = constraint.tangent_u;
  const WideReal before_v = constraint.tangent_v;
  const WideReal limit = constraint.friction * constraint.normal_impulse;
  const WideMat2& m = constraint.tangent_mass;
  constraint.tangent_u = before_u - (m.uu * slip_u + m.uv * slip_v);
  constraint.tangent_v = before_v - (m.vu * slip_u + m.vv * slip_v);
  const WideMask slides = square_root(constraint.tangent_u * constraint.tangent_u +
                                      constraint.tangent_v * constraint.tangent_v) > limit;
  if (any(slides)) {
    const WideReal mass = sliding_mass(constraint);
    const WideReal u = before_u - mass * slip_u;
    const WideReal w = before_v - mass * slip_v;
    const WideReal length = square_root(u * u + w * w);
    const WideReal scale = limit / length;
    const WideMask outside = length > limit;
    constraint.tangent_u = select(slides, select(outside, scale * u, u), constraint.tangent_u);
    constraint.tangent_v = select(slides, select(outside, scale * w, w), constraint.tangent_v);
  }
  pair.apply(constraint, (constraint.tangent_u - before_u) * constraint.u +
                             (constraint.tangent_v - before_v) * v);
}

}  // namespace cs550::CS550_LANES
