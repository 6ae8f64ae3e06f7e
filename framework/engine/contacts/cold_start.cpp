#include <algorithm>
#include <cmath>

#include "engine/world/world_state.hpp"

/// @file cold_start.cpp
/// A first guess for contacts that have no impulses of an earlier step to start from.
///
/// A pass over a box's four corners in turn tips the box a little: the first corner carries the whole
/// weight until the others had their turn. Ten boxes that are put on each other at once need thousands
/// of passes to forget that. So resting contacts begin with the load that they would carry if each
/// pair of bodies touched in one point, the middle of its contact points: one unknown per pair, found
/// by symmetric Gauss–Seidel sweeps, and shared out evenly among the points.

namespace cs550 {

namespace {

/// Sweeps end when none changes a velocity by more than this share of what gravity gives in a substep,
/// or when they have cost this much. A load a thousand times heavier than its support takes thousands.
constexpr Real enough = Real(1e-5);
constexpr std::size_t most_visits = 200'000;

SolverBody& velocity_of(WorldState& world, Index body) {
  return world.velocities[static_cast<std::size_t>(body)];
}

Real approach(WorldState& world, const ContactConstraint& constraint) {
  const SolverBody& a = velocity_of(world, constraint.body_a);
  const SolverBody& b = velocity_of(world, constraint.body_b);
  return constraint.n.dot(b.v + b.w.cross(constraint.r_b) - a.v - a.w.cross(constraint.r_a));
}

void push_apart(WorldState& world, const ContactConstraint& constraint, Real impulse) {
  velocity_of(world, constraint.body_a).apply(-impulse * constraint.n, constraint.r_a);
  velocity_of(world, constraint.body_b).apply(impulse * constraint.n, constraint.r_b);
}

const ContactConstraint& constraint_at(const WorldState& world, Index place) {
  return world.constraints[static_cast<std::size_t>(place)];
}

/// One constraint in the middle of those of a pair.
ContactConstraint middle_constraint(WorldState& world, std::span<const Index> places) {
  ContactConstraint middle = constraint_at(world, places[0]);
  for (const Index place : places.subspan(1)) {
    const ContactConstraint& constraint = constraint_at(world, place);
    middle.r_a += constraint.r_a;
    middle.r_b += constraint.r_b;
    middle.separation = std::min(middle.separation, constraint.separation);
  }
  middle.r_a /= static_cast<Real>(places.size());
  middle.r_b /= static_cast<Real>(places.size());
  middle.normal_mass =
      constraint_mass(contact_jacobian(middle.n, middle.r_a, middle.r_b),
                      velocity_of(world, middle.body_a), velocity_of(world, middle.body_b));
  return middle;
}

bool is_fresh(const WorldState& world, std::span<const Index> places) {
  return std::all_of(places.begin(), places.end(),
                     [&](Index place) { return constraint_at(world, place).normal_impulse == 0; });
}

/// The pairs that are new and slow. @pre velocities are those of the bodies
void list_cold_pairs(WorldState& world) {
  world.cold_pairs.clear();
  const Real slow = world.settings.restitution_threshold * world.settings.length_unit;
  for_constraints_of_contacts(world, [&](const Contact&, std::span<const Index> places) {
    if (places.empty() || !is_fresh(world, places)) return;
    const ContactConstraint middle = middle_constraint(world, places);
    if (std::abs(approach(world, middle)) < slow) world.cold_pairs.push_back({places, middle});
  });
}

/// Leaves velocities as gravity and the impulses that are known will make them.
void predict_velocities(WorldState& world, Real h) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (body.kind == BodyKind::Dynamic) world.velocities[i].v += h * body.inverse_mass * body.force;
  }
  for (const ContactConstraint& constraint : world.constraints)
    push_apart(world, constraint, constraint.normal_impulse);
}

/// Improves the load of one pair; returns how much velocity that changed (m/s).
Real improve(WorldState& world, ContactConstraint& constraint, Real h) {
  if (constraint.normal_mass == 0) return 0;
  const Real gap_speed = std::max(constraint.separation, Real(0)) / h;
  const Real before = constraint.normal_impulse;
  const Real wanted = before - constraint.normal_mass * (approach(world, constraint) + gap_speed);
  constraint.normal_impulse = std::max(Real(0), wanted);
  push_apart(world, constraint, constraint.normal_impulse - before);
  return std::abs(constraint.normal_impulse - before) / constraint.normal_mass;
}

}  // namespace

void guess_cold_impulses(WorldState& world, Real h) {
  list_cold_pairs(world);
  auto& pairs = world.cold_pairs;
  if (pairs.empty()) return;
  predict_velocities(world, h);

  const Real tolerance = enough * h * world.settings.gravity.norm();
  const std::size_t most_sweeps = most_visits / pairs.size();
  Real change = HUGE_VALF;
  for (std::size_t sweep = 0; sweep < most_sweeps && change > tolerance; ++sweep) {
    change = 0;
    const auto visit = [&](ColdPair& pair) {
      change = std::max(change, improve(world, pair.middle, h));
    };
    if (sweep % 2 == 0) {
      std::for_each(pairs.begin(), pairs.end(), visit);
    } else {
      std::for_each(pairs.rbegin(), pairs.rend(), visit);
    }
  }
  for (const ColdPair& pair : pairs) {
    for (const Index place : pair.constraints) {
      world.constraints[static_cast<std::size_t>(place)].normal_impulse =
          pair.middle.normal_impulse / static_cast<Real>(pair.constraints.size());
    }
  }
  pairs.clear();  // they look into this world's constraint order: a copy of the world must not
}

}  // namespace cs550
