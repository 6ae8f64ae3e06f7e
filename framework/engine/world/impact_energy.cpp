/// @file impact_energy.cpp
/// Newton's law of restitution prescribes a velocity and knows no energy. It can give energy where contacts
/// that bounce act together with others that do not, and where the approach is no longer what it was: a
/// plate that came with its tip may turn flat within the substep, and its contact then has twenty times the
/// effective mass. The energetic law (Stronge 1990) says what is left to give: at most the energy that
/// the impact has taken.

#include "engine/world/impact_energy.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contacts/contact_constraints.hpp"
#include "engine/islands/forest.hpp"
#include "engine/world/overlap_recovery.hpp"

namespace cs550 {

namespace {

/// Of rounding, relative to the energy.
constexpr double tolerance = 1e-6;

/// vᵀMw for two velocities of a body (J).
double mass_product(const RigidBody& body, const SolverBody& x, const SolverBody& y) {
  const Vec3 turn_x = body.pose.unrotate(x.w);
  const Vec3 turn_y = body.pose.unrotate(y.w);
  return static_cast<double>(body.mass * x.v.dot(y.v) + turn_x.dot(body.inertia * turn_y));
}

/// Adds what E(s) = start + linear·s + square·s² needs of a body: its energy if the part s of its change of
/// velocity takes place.
void add_change(ImpactGroup& group, const RigidBody& body, const SolverBody& start,
                const SolverBody& end) {
  SolverBody change;
  change.v = end.v - start.v;
  change.w = end.w - start.w;
  group.start += mass_product(body, start, start) / 2;
  group.linear += mass_product(body, start, change);
  group.square += mass_product(body, change, change) / 2;
}

bool exceeds(double energy, double allowed) { return energy > (1 + tolerance) * allowed; }

bool gains(const ImpactGroup& group) { return exceeds(group.after, group.before); }

/// Calls `visit(group, index)` for every body that contacts may move.
template <class Visit>
void for_bodies_of_groups(WorldState& world, const Visit& visit) {
  Impacts& impacts = world.impacts;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].kind != BodyKind::Dynamic || world.bodies[i].asleep) continue;
    visit(impacts.groups[root_of(impacts.parent, static_cast<Index>(i))], i);
  }
}

void join_connected_bodies(WorldState& world) {
  std::vector<Index>& parent = world.impacts.parent;
  plant_forest(parent, world.bodies.size());
  for (const ContactConstraint& constraint : world.constraints) {
    const RigidBody& a = world.bodies[constraint.body_a];
    const RigidBody& b = world.bodies[constraint.body_b];
    if (a.kind == BodyKind::Dynamic && b.kind == BodyKind::Dynamic) {
      join(parent, constraint.body_a, constraint.body_b);
    }
  }
}

/// Sums the energies of the groups. @returns whether any has gained
bool any_gains(WorldState& world, std::span<const SolverBody> bodies) {
  Impacts& impacts = world.impacts;
  impacts.groups.assign(world.bodies.size(), {});
  for_bodies_of_groups(world, [&](ImpactGroup& group, std::size_t i) {
    group.before += impacts.energy_before[i];
    group.after += mass_product(world.bodies[i], bodies[i], bodies[i]) / 2;
  });
  return std::any_of(impacts.groups.begin(), impacts.groups.end(), gains);
}

void sum_changes(WorldState& world, std::span<const SolverBody> bodies) {
  for_bodies_of_groups(world, [&](ImpactGroup& group, std::size_t i) {
    if (gains(group)) add_change(group, world.bodies[i], world.impacts.bodies[i], bodies[i]);
  });
}

bool moves(const RigidBody& body) {
  return body.kind == BodyKind::Kinematic &&
         !(body.linear_velocity.isZero(0) && body.angular_velocity.isZero(0));
}

void mark_pushed_groups(WorldState& world) {
  Impacts& impacts = world.impacts;
  for (const ContactConstraint& constraint : world.constraints) {
    if (moves(world.bodies[constraint.body_a])) {
      impacts.groups[root_of(impacts.parent, constraint.body_b)].is_pushed = true;
    }
    if (moves(world.bodies[constraint.body_b])) {
      impacts.groups[root_of(impacts.parent, constraint.body_a)].is_pushed = true;
    }
  }
}

/// The largest part of the change that a group may have: the root of E(s) = allowed.
Real allowed_part(const ImpactGroup& group) {
  if (group.is_pushed || !gains(group)) return 1;
  const double allowed = std::max(group.before, group.start);
  if (!exceeds(group.after, allowed)) return 1;
  const double half = group.linear / 2;
  const double root = std::sqrt(half * half + group.square * (allowed - group.start));
  return static_cast<Real>((root - half) / group.square);
}

void scale_body(SolverBody& body, const SolverBody& start, Real part) {
  body.v = start.v + part * (body.v - start.v);
  body.w = start.w + part * (body.w - start.w);
}

/// The impulses along n, u and v.
Vec3 impulses_of(const ContactConstraint& constraint) {
  return {constraint.normal_impulse, constraint.tangent_impulse.x(),
          constraint.tangent_impulse.y()};
}

void scale_impulses(ContactConstraint& constraint, const Vec3& start, Real part) {
  const Vec3 scaled = start + part * (impulses_of(constraint) - start);
  constraint.normal_impulse = scaled.x();
  constraint.tangent_impulse = scaled.tail<2>();
}

}  // namespace

void note_energy_before_impacts(WorldState& world) {
  std::vector<double>& energies = world.impacts.energy_before;
  energies.clear();
  for (const RigidBody& body : world.bodies) {
    energies.push_back(static_cast<double>(kinetic_energy(body)));
  }
}

void begin_impacts(WorldState& world, std::span<const SolverBody> bodies) {
  read_back_impulses(world);
  world.impacts.bodies.assign(bodies.begin(), bodies.end());
  std::vector<Vec3>& impulses = world.impacts.impulses;
  impulses.clear();
  for (const ContactConstraint& constraint : world.constraints) {
    const bool taken_back = world.recovery.any && recovers(world, constraint);
    impulses.push_back(taken_back ? Vec3::Zero() : impulses_of(constraint));
  }
}

void limit_impact_energy(WorldState& world, std::span<SolverBody> bodies) {
  Impacts& impacts = world.impacts;
  join_connected_bodies(world);
  if (!any_gains(world, bodies)) return;
  sum_changes(world, bodies);
  mark_pushed_groups(world);
  const auto part_of = [&](Index body) {
    return allowed_part(impacts.groups[root_of(impacts.parent, body)]);
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Real part = part_of(static_cast<Index>(i));
    if (part < 1) scale_body(bodies[i], impacts.bodies[i], part);
  }
  for (std::size_t i = 0; i < world.constraints.size(); ++i) {
    ContactConstraint& constraint = world.constraints[i];
    const Real part = std::min(part_of(constraint.body_a), part_of(constraint.body_b));
    if (part < 1) scale_impulses(constraint, impacts.impulses[i], part);
  }
}

}  // namespace cs550
