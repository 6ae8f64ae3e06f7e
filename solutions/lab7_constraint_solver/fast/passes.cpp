/// @file passes.cpp
/// L7.8 for the engine: the rows of a pass, four at a time, with the bits of the teaching form.
///
/// Rows that share no movable body do not see each other: solved together they give what they give one
/// after the other. So neighbours in the array are taken together as long as that holds, and bodies
/// stay in registers while the rows that follow belong to the same pairs; the world puts such rows
/// side by side (row_order.cpp). Four chains of dependent operations then run at once, each of which
/// alone would leave the processor waiting most of the time.

#include <cstddef>
#include <span>

#include "batch.hpp"
#include "cs550/constraint_solver.hpp"

namespace cs550 {

namespace {

/// The rows of a pass in the order in which they are visited.
class Visits {
 public:
  Visits(std::span<ContactRow> rows, bool backwards) : rows_(rows), backwards_(backwards) {}

  std::size_t size() const { return rows_.size(); }
  ContactRow& operator[](std::size_t i) const {
    return rows_[backwards_ ? rows_.size() - 1 - i : i];
  }

 private:
  std::span<ContactRow> rows_;
  bool backwards_;
};

/// Up to four pairs of bodies, of which no two share a movable one; the lanes that are left hold bodies
/// at rest.
class Pairs {
 public:
  explicit Pairs(std::span<BodyVelocity> bodies) : bodies_(bodies) {}

  /// Takes the pairs of as many rows as it can, from the given one on. @returns how many
  std::size_t take(const Visits& rows, std::size_t first) {
    count_ = 0;
    while (first + count_ < rows.size() && add(rows[first + count_])) {
    }
    for (std::size_t lane = count_; lane < lane_count; ++lane) a_[lane] = b_[lane] = &at_rest_;
    return count_;
  }

  /// How many of the rows from the given one on belong to the same pairs in turn.
  std::size_t repeats(const Visits& rows, std::size_t first) const {
    std::size_t lane = 0;
    while (lane < count_ && first + lane < rows.size() &&
           &body(rows[first + lane].body_a) == a_[lane] &&
           &body(rows[first + lane].body_b) == b_[lane]) {
      ++lane;
    }
    return lane;
  }

  FourStructs<BodyVelocity> bodies_a() const { return FourStructs<BodyVelocity>(a_); }
  FourStructs<BodyVelocity> bodies_b() const { return FourStructs<BodyVelocity>(b_); }

 private:
  BodyVelocity& body(Index i) const { return bodies_[static_cast<std::size_t>(i)]; }

  bool add(const ContactRow& row) {
    BodyVelocity& a = body(row.body_a);
    BodyVelocity& b = body(row.body_b);
    if (count_ == lane_count || is_taken(a) || is_taken(b)) return false;
    a_[count_] = &a;
    b_[count_] = &b;
    ++count_;
    return true;
  }

  bool is_taken(const BodyVelocity& body) const {
    if (body.inverse_mass == 0) return false;
    bool taken = false;
    for (std::size_t i = 0; i < count_; ++i) taken |= a_[i] == &body || b_[i] == &body;
    return taken;
  }

  std::span<BodyVelocity> bodies_;
  std::size_t count_ = 0;
  BodyVelocity* a_[lane_count] = {};
  BodyVelocity* b_[lane_count] = {};
  BodyVelocity at_rest_;
};

void apply_pair(const RowLanes& row, const Vec3Lanes& impulse, BodyLanes& a, BodyLanes& b) {
  a.apply(-impulse, row.r_a);
  b.apply(impulse, row.r_b);
}

Vec3Lanes relative_velocity(const RowLanes& row, const BodyLanes& a, const BodyLanes& b) {
  return b.v + b.w.cross(row.r_b) - a.v - a.w.cross(row.r_a);
}

Lanes present_separation(const RowLanes& row, const BodyLanes& a, const BodyLanes& b) {
  const Vec3Lanes moved = b.delta_position + b.delta_rotation.cross(row.r_b) - a.delta_position -
                          a.delta_rotation.cross(row.r_a);
  return row.separation + row.n.dot(moved);
}

struct BiasLanes {
  Lanes velocity, mass_scale, impulse_scale;
};

BiasLanes contact_bias(const RowLanes& row, Lanes separation, const ContactStep& step) {
  const Lanes zero = all_lanes(0);
  const Lanes fastest = all_lanes(-step.max_push_speed);
  BiasLanes in_touch{zero, all_lanes(1), zero};
  if (step.use_bias && step.model == ContactModel::Soft) {
    in_touch.velocity = larger(row.bias_rate * separation, fastest);
    in_touch.mass_scale = row.mass_scale;
    in_touch.impulse_scale = row.impulse_scale;
  } else if (step.use_bias) {
    const Lanes excess = smaller(separation + all_lanes(step.slop), zero);
    in_touch.velocity = larger(all_lanes(step.baumgarte / step.h) * excess, fastest);
  }
  const LaneMask apart = separation > zero;
  BiasLanes bias;
  bias.velocity = apart ? separation / all_lanes(step.h) : in_touch.velocity;
  bias.mass_scale = apart ? all_lanes(1) : in_touch.mass_scale;
  bias.impulse_scale = apart ? zero : in_touch.impulse_scale;
  if (step.use_bias && step.model == ContactModel::Baumgarte) {
    const LaneMask bounces =
        (row.restitution > zero) & (row.approach_velocity < all_lanes(-step.restitution_threshold));
    const Lanes bounce = row.restitution * row.approach_velocity;
    bias.velocity = bounces ? smaller(bias.velocity, bounce) : bias.velocity;
  }
  return bias;
}

void solve_normal(RowLanes& row, BodyLanes& a, BodyLanes& b, const ContactStep& step) {
  const BiasLanes bias = contact_bias(row, present_separation(row, a, b), step);
  const Lanes jv = row.n.dot(relative_velocity(row, a, b));
  const Lanes impulse = -bias.mass_scale * row.normal_mass * (jv + bias.velocity) -
                        bias.impulse_scale * row.normal_impulse;
  const Lanes before = row.normal_impulse;
  row.normal_impulse = larger(before + impulse, all_lanes(0));
  apply_pair(row, (row.normal_impulse - before) * row.n, a, b);
}

/// The smaller eigenvalue of tangent_mass.
Lanes sliding_mass(const RowLanes& row) {
  const Lanes half_trace = all_lanes(Real(0.5)) * (row.uu + row.vv);
  const Lanes determinant = row.uu * row.vv - row.vu * row.uv;
  return half_trace - square_root(larger(all_lanes(0), half_trace * half_trace - determinant));
}

void solve_friction(RowLanes& row, BodyLanes& a, BodyLanes& b) {
  const Vec3Lanes v = row.n.cross(row.u);
  const Vec3Lanes relative = relative_velocity(row, a, b);
  const Lanes slip_u = row.u.dot(relative);
  const Lanes slip_v = v.dot(relative);
  const Lanes before_u = row.tangent_u;
  const Lanes before_v = row.tangent_v;
  const Lanes limit = row.friction * row.normal_impulse;
  row.tangent_u = before_u - (row.uu * slip_u + row.uv * slip_v);
  row.tangent_v = before_v - (row.vu * slip_u + row.vv * slip_v);
  const LaneMask slides =
      square_root(row.tangent_u * row.tangent_u + row.tangent_v * row.tangent_v) > limit;
  if (any(slides)) {
    const Lanes mass = sliding_mass(row);
    const Lanes u = before_u - mass * slip_u;
    const Lanes w = before_v - mass * slip_v;
    const Lanes length = square_root(u * u + w * w);
    const Lanes scale = limit / length;
    row.tangent_u = slides ? (length > limit ? scale * u : u) : row.tangent_u;
    row.tangent_v = slides ? (length > limit ? scale * w : w) : row.tangent_v;
  }
  apply_pair(row, (row.tangent_u - before_u) * row.u + (row.tangent_v - before_v) * v, a, b);
}

/// Rows of different lanes. Those beyond `count` have no mass.
[[gnu::flatten]] void solve_rows(const Visits& visits, std::size_t first, std::size_t count,
                                 BodyLanes& a, BodyLanes& b, const ContactStep& step) {
  ContactRow idle;
  ContactRow* items[lane_count];
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    items[lane] = lane < count ? &visits[first + lane] : &idle;
  }
  const FourStructs<ContactRow> rows(items);
  RowLanes row(rows);
  if (step.backwards) {
    solve_friction(row, a, b);
    solve_normal(row, a, b, step);
  } else {
    solve_normal(row, a, b, step);
    solve_friction(row, a, b);
  }
  row.store_impulses(rows);
}

}  // namespace

void solve_contacts(std::span<ContactRow> rows, std::span<BodyVelocity> bodies,
                    const ContactStep& step) {
  const Visits visits(rows, step.backwards);
  Pairs pairs(bodies);
  for (std::size_t i = 0; i < visits.size();) {
    std::size_t count = pairs.take(visits, i);
    BodyLanes a(pairs.bodies_a());
    BodyLanes b(pairs.bodies_b());
    do {
      solve_rows(visits, i, count, a, b, step);
      i += count;
      count = pairs.repeats(visits, i);
    } while (count > 0);
    a.store_velocities(pairs.bodies_a());
    b.store_velocities(pairs.bodies_b());
  }
}

}  // namespace cs550
