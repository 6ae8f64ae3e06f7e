/// @file solve_contacts.cpp
/// L7.8 for the engine: a pass over the constraints, four at a time, with the bits of the teaching
/// form.
///
/// Constraints that share no movable body do not affect each other: solved together they give the
/// same result as one after the other. Neighbours in the array are therefore solved together as
/// long as that holds, and the world puts such constraints side by side (solve_order.cpp). Bodies
/// stay in registers while the constraints that follow belong to the same pairs. Four chains of
/// dependent operations then run at once. Each of them alone would leave the processor waiting most
/// of the time.

#include <cstddef>
#include <span>

#include "batch.hpp"
#include "cs550/constraint_solver.hpp"

namespace cs550 {

namespace {

/// The constraints of a pass in the order in which they are visited.
class Visits {
 public:
  Visits(std::span<ContactConstraint> constraints, bool backwards)
      : constraints_(constraints), backwards_(backwards) {}

  std::size_t size() const { return constraints_.size(); }
  ContactConstraint& operator[](std::size_t i) const {
    return constraints_[backwards_ ? constraints_.size() - 1 - i : i];
  }

 private:
  std::span<ContactConstraint> constraints_;
  bool backwards_;
};

/// Up to four pairs of bodies. No two pairs share a movable body. An unused lane holds a body of its
/// own at rest.
class Pairs {
 public:
  explicit Pairs(std::span<SolverBody> bodies) : bodies_(bodies) {}

  /// Takes the pairs of as many consecutive constraints as possible. @returns how many
  std::size_t take(const Visits& constraints, std::size_t first) {
    count_ = 0;
    while (first + count_ < constraints.size() && add(constraints[first + count_])) {
    }
    for (std::size_t lane = count_; lane < lane_count; ++lane) a_[lane] = b_[lane] = &at_rest_;
    return count_;
  }

  /// How many of the constraints that follow belong to the same pairs, lane by lane.
  std::size_t repeats(const Visits& constraints, std::size_t first) const {
    std::size_t lane = 0;
    while (lane < count_ && first + lane < constraints.size() &&
           &body(constraints[first + lane].body_a) == a_[lane] &&
           &body(constraints[first + lane].body_b) == b_[lane]) {
      ++lane;
    }
    return lane;
  }

  const PerLane<SolverBody>& bodies_a() const { return a_; }
  const PerLane<SolverBody>& bodies_b() const { return b_; }

 private:
  SolverBody& body(Index i) const { return bodies_[i]; }

  bool add(const ContactConstraint& constraint) {
    SolverBody& a = body(constraint.body_a);
    SolverBody& b = body(constraint.body_b);
    if (count_ == lane_count || is_taken(a) || is_taken(b)) return false;
    a_[count_] = &a;
    b_[count_] = &b;
    ++count_;
    return true;
  }

  bool is_taken(const SolverBody& body) const {
    if (body.inverse_mass == 0) return false;
    bool taken = false;
    for (std::size_t i = 0; i < count_; ++i) taken |= a_[i] == &body || b_[i] == &body;
    return taken;
  }

  std::span<SolverBody> bodies_;
  std::size_t count_ = 0;
  PerLane<SolverBody> a_{};
  PerLane<SolverBody> b_{};
  SolverBody at_rest_;
};

void apply_pair(const WideConstraint& constraint, const WideVec3& impulse, WideBody& a,
                WideBody& b) {
  a.apply(-impulse, constraint.r_a);
  b.apply(impulse, constraint.r_b);
}

WideVec3 relative_velocity(const WideConstraint& constraint, const WideBody& a, const WideBody& b) {
  return b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a);
}

WideReal present_separation(const WideConstraint& constraint, const WideBody& a,
                            const WideBody& b) {
  const WideVec3 moved = b.delta_position + b.delta_rotation.cross(constraint.r_b) -
                         a.delta_position - a.delta_rotation.cross(constraint.r_a);
  return constraint.separation + constraint.n.dot(moved);
}

struct WideBias {
  WideReal velocity, mass_scale, impulse_scale;
};

WideBias contact_bias(const WideConstraint& constraint, WideReal separation,
                      const ContactStep& step) {
  const WideReal zero = all_lanes(0);
  const WideReal fastest = all_lanes(-step.max_push_speed);
  WideBias in_touch{zero, all_lanes(1), zero};
  if (step.use_bias && step.model == ContactModel::Soft) {
    in_touch.velocity = larger(constraint.bias_rate * separation, fastest);
    in_touch.mass_scale = constraint.mass_scale;
    in_touch.impulse_scale = constraint.impulse_scale;
  } else if (step.use_bias) {
    const WideReal excess = smaller(separation + all_lanes(step.slop), zero);
    in_touch.velocity = larger(all_lanes(step.baumgarte / step.h) * excess, fastest);
  }
  const WideMask apart = separation > zero;
  WideBias bias;
  bias.velocity = apart ? separation / all_lanes(step.h) : in_touch.velocity;
  bias.mass_scale = apart ? all_lanes(1) : in_touch.mass_scale;
  bias.impulse_scale = apart ? zero : in_touch.impulse_scale;
  if (step.use_bias && step.model == ContactModel::Baumgarte) {
    const WideMask bounces =
        (constraint.restitution > zero) &
        (constraint.approach_velocity < all_lanes(-step.restitution_threshold));
    const WideReal bounce = constraint.restitution * constraint.approach_velocity;
    bias.velocity = bounces ? smaller(bias.velocity, bounce) : bias.velocity;
  }
  return bias;
}

void solve_normal(WideConstraint& constraint, WideBody& a, WideBody& b, const ContactStep& step) {
  const WideBias bias = contact_bias(constraint, present_separation(constraint, a, b), step);
  const WideReal jv = constraint.n.dot(relative_velocity(constraint, a, b));
  const WideReal impulse = -bias.mass_scale * constraint.normal_mass * (jv + bias.velocity) -
                           bias.impulse_scale * constraint.normal_impulse;
  const WideReal before = constraint.normal_impulse;
  constraint.normal_impulse = larger(before + impulse, all_lanes(0));
  apply_pair(constraint, (constraint.normal_impulse - before) * constraint.n, a, b);
}

/// The smaller eigenvalue of tangent_mass.
WideReal sliding_mass(const WideConstraint& constraint) {
  const WideMat2& m = constraint.tangent_mass;
  const WideReal half_trace = all_lanes(Real(0.5)) * (m.uu + m.vv);
  const WideReal determinant = m.uu * m.vv - m.vu * m.uv;
  return half_trace - square_root(larger(all_lanes(0), half_trace * half_trace - determinant));
}

void solve_friction(WideConstraint& constraint, WideBody& a, WideBody& b) {
  const WideVec3 v = constraint.n.cross(constraint.u);
  const WideVec3 relative = relative_velocity(constraint, a, b);
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
    constraint.tangent_u = slides ? (length > limit ? scale * u : u) : constraint.tangent_u;
    constraint.tangent_v = slides ? (length > limit ? scale * w : w) : constraint.tangent_v;
  }
  apply_pair(
      constraint,
      (constraint.tangent_u - before_u) * constraint.u + (constraint.tangent_v - before_v) * v, a,
      b);
}

/// Solves `count` consecutive constraints, one per lane. The remaining lanes have no mass.
[[gnu::flatten]] void solve_constraints(const Visits& visits, std::size_t first, std::size_t count,
                                        WideBody& a, WideBody& b, const ContactStep& step) {
  ContactConstraint idle;
  PerLane<ContactConstraint> constraints;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    constraints[lane] = lane < count ? &visits[first + lane] : &idle;
  }
  WideConstraint constraint(constraints);
  if (step.backwards) {
    solve_friction(constraint, a, b);
    solve_normal(constraint, a, b, step);
  } else {
    solve_normal(constraint, a, b, step);
    solve_friction(constraint, a, b);
  }
  constraint.store_impulses(constraints);
}

}  // namespace

void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step) {
  const Visits visits(constraints, step.backwards);
  Pairs pairs(bodies);
  for (std::size_t i = 0; i < visits.size();) {
    std::size_t count = pairs.take(visits, i);
    WideBody a(pairs.bodies_a());
    WideBody b(pairs.bodies_b());
    do {
      solve_constraints(visits, i, count, a, b, step);
      i += count;
      count = pairs.repeats(visits, i);
    } while (count > 0);
    a.store_velocities(pairs.bodies_a());
    b.store_velocities(pairs.bodies_b());
  }
}

}  // namespace cs550
