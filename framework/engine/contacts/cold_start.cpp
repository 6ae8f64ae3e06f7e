#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contacts/contact_constraints.hpp"

/// @file cold_start.cpp
/// A first guess for contacts that have no impulses from an earlier step.
///
/// A pass over a box's four corners in turn tips the box a little: the first corner carries the
/// whole weight until the others have been solved. Ten boxes that are stacked at once need
/// thousands of passes to recover. Resting contacts therefore start with the load that they would
/// carry if each pair of bodies touched at one point, the middle of its contact points. That is one
/// unknown per pair. It is found by symmetric Gauss–Seidel sweeps and shared evenly among the
/// points.

namespace cs550 {

namespace {

/// Sweeps end when none changes a velocity by more than this fraction of what gravity adds in a
/// substep, or by more than rounding does, or at this cost. A load a thousand times heavier than its support takes
/// thousands of sweeps.
constexpr Real enough = Real(1e-5);
constexpr std::size_t most_visits = 200'000;

Real approach(std::span<const SolverBody> bodies, const ContactConstraint& constraint) {
  const SolverBody& a = bodies[constraint.body_a];
  const SolverBody& b = bodies[constraint.body_b];
  return constraint.n.dot(b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a));
}

void push_apart(std::span<SolverBody> bodies, const ContactConstraint& constraint, Real impulse) {
  bodies[constraint.body_a].apply(-impulse * constraint.n, constraint.r_a);
  bodies[constraint.body_b].apply(impulse * constraint.n, constraint.r_b);
}

/// One constraint in the middle of those of a pair, without mass.
ContactConstraint middle_constraint(const WorldState& world, Index contact) {
  const std::span<const Index> places = world.solve_order.places_of(contact);
  ContactConstraint middle = world.constraints[places[0]];
  for (const Index place : places.subspan(1)) {
    const ContactConstraint& constraint = world.constraints[place];
    middle.r_a += constraint.r_a;
    middle.r_b += constraint.r_b;
    middle.separation = std::min(middle.separation, constraint.separation);
  }
  middle.r_a /= static_cast<Real>(places.size());
  middle.r_b /= static_cast<Real>(places.size());
  return middle;
}

/// The speed at which a gap closes within a substep (m/s).
Real gap_speed(const ContactConstraint& constraint, Real h) {
  return std::max(constraint.separation, Real(0)) / h;
}

bool is_fresh(const WorldState& world, Index contact) {
  const std::span<const Index> places = world.solve_order.places_of(contact);
  return std::all_of(places.begin(), places.end(),
                     [&](Index place) { return world.constraints[place].normal_impulse == 0; });
}

bool is_slow(const WorldState& world, Index contact, Real h) {
  const ContactConstraint middle = middle_constraint(world, contact);
  const Real slow = world.settings.restitution_threshold * world.settings.length_unit;
  const Real speed = approach(world.solver_bodies, middle);
  return std::abs(speed) < slow && speed + gap_speed(middle, h) < slow;
}

/// A constraint for each cold pair, in the order of the contacts.
void list_cold_pairs(WorldState& world) {
  std::vector<ColdPair>& pairs = world.cold_start.pairs;
  std::size_t count = 0;
  for (const Index contact : world.solve_order.contacts) {
    if (!world.cold_start.is_pair_cold[contact]) continue;
    if (count == pairs.size()) pairs.emplace_back();
    pairs[count++].contact = contact;
  }
  pairs.resize(count);
  constexpr std::size_t block = 16;
  for_blocks(world.team, count, block, [&](std::size_t first, std::size_t last) {
    for (ColdPair& pair : std::span(pairs).subspan(first, last - first)) {
      ContactConstraint& middle = pair.middle = middle_constraint(world, pair.contact);
      middle.normal_mass =
          constraint_mass(contact_jacobian(middle.n, middle.r_a, middle.r_b),
                          world.solver_bodies[middle.body_a], world.solver_bodies[middle.body_b]);
    }
  });
}

/// Marks the movable bodies of cold pairs: the sweeps use their velocities only.
void mark_cold_bodies(WorldState& world) {
  std::vector<char>& is_cold = world.cold_start.is_cold;
  is_cold.assign(world.bodies.size(), 0);
  for (const ColdPair& pair : world.cold_start.pairs) {
    for (const Index body : {pair.middle.body_a, pair.middle.body_b}) {
      is_cold[body] = world.bodies[body].kind == BodyKind::Dynamic;
    }
  }
}

/// Adds the velocities that gravity gives to the marked bodies of a block.
void predict_falls(const WorldState& world, std::size_t first, std::size_t last, Real h,
                   std::span<SolverBody> bodies) {
  for (std::size_t i = first; i < last; ++i) {
    bodies[i] = world.solver_bodies[i];
    const RigidBody& body = world.bodies[i];
    if (world.cold_start.is_cold[i]) bodies[i].v += h * body.inverse_mass * body.force;
  }
}

/// Adds the velocities that the known impulses give to the marked bodies.
void predict_pushes(std::span<const ContactConstraint> constraints,
                    const std::vector<char>& is_cold, std::span<SolverBody> bodies) {
  for (const ContactConstraint& constraint : constraints) {
    const auto [a, b] = std::pair(constraint.body_a, constraint.body_b);
    if (!is_cold[a] && !is_cold[b]) continue;
    const Vec3 impulse = constraint.normal_impulse * constraint.n;
    if (is_cold[a]) bodies[a].apply(-impulse, constraint.r_a);
    if (is_cold[b]) bodies[b].apply(impulse, constraint.r_b);
  }
}

/// The velocities that gravity and the known impulses will give the marked bodies.
void predict_velocities(WorldState& world, Real h) {
  ColdStart& cold = world.cold_start;
  cold.bodies.resize(world.bodies.size());
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    predict_falls(world, first, last, h, cold.bodies);
  });
  for_units_by_phase(world.team, world.solve_order, false, [&](std::size_t unit) {
    predict_pushes(constraints_of(world, world.solve_order.units[unit]), cold.is_cold, cold.bodies);
  });
}

/// What rounding may change about the approach of a pair (m/s).
Real rounding_of_approach(std::span<const SolverBody> bodies, const ContactConstraint& constraint) {
  constexpr Real rounding = 4 * std::numeric_limits<Real>::epsilon();
  return rounding * (bodies[constraint.body_a].v.norm() + bodies[constraint.body_b].v.norm());
}

/// Improves the load of one pair. @returns by how much a velocity changed (m/s), 0 if no more than by rounding
Real improve(std::span<SolverBody> bodies, ContactConstraint& constraint, Real h) {
  if (constraint.normal_mass == 0) return 0;
  const Real before = constraint.normal_impulse;
  const Real parting = approach(bodies, constraint) + gap_speed(constraint, h);
  const Real wanted = before - constraint.normal_mass * parting;
  constraint.normal_impulse = std::max(Real(0), wanted);
  push_apart(bodies, constraint, constraint.normal_impulse - before);
  const Real change = std::abs(constraint.normal_impulse - before) / constraint.normal_mass;
  return change > rounding_of_approach(bodies, constraint) ? change : 0;
}

/// Sweeps back and forth until the loads no longer change.
void sweep(ColdStart& cold, Real tolerance, Real h) {
  const std::size_t most_sweeps = most_visits / cold.pairs.size();
  Real change = HUGE_VALF;
  for (std::size_t sweep = 0; sweep < most_sweeps && change > tolerance; ++sweep) {
    change = 0;
    const auto visit = [&](ColdPair& pair) {
      change = std::max(change, improve(cold.bodies, pair.middle, h));
    };
    if (sweep % 2 == 0) {
      std::for_each(cold.pairs.begin(), cold.pairs.end(), visit);
    } else {
      std::for_each(cold.pairs.rbegin(), cold.pairs.rend(), visit);
    }
  }
}

}  // namespace

void note_if_cold(WorldState& world, Index contact, Real h) {
  const bool is_cold = is_fresh(world, contact) && is_slow(world, contact, h);
  world.cold_start.is_pair_cold[contact] = static_cast<char>(is_cold);
}

void guess_cold_impulses(WorldState& world, Real h) {
  ColdStart& cold = world.cold_start;
  list_cold_pairs(world);
  if (cold.pairs.empty()) return;
  mark_cold_bodies(world);
  predict_velocities(world, h);
  sweep(cold, enough * h * world.settings.gravity.norm(), h);
  for (const ColdPair& pair : cold.pairs) {
    const std::span<const Index> places = world.solve_order.places_of(pair.contact);
    for (const Index place : places) {
      world.constraints[place].normal_impulse =
          pair.middle.normal_impulse / static_cast<Real>(places.size());
    }
  }
}

}  // namespace cs550
