#include "engine/world/overlap_recovery.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/body_sweeps.hpp"
#include "engine/contacts/contact_constraints.hpp"
#include "engine/contacts/solver_bodies.hpp"
#include "engine/islands/forest.hpp"
#include "engine/pairs/near_pairs.hpp"

/// @file overlap_recovery.cpp
/// A scene may put bodies into each other. The bias pushes them apart, and the relax passes should
/// take the speed of the push out again. In a heap of such bodies these are far too few. Friction
/// makes it worse: it ties the bodies together, so that the push of one contact drives all others,
/// and its limit grows with the impulses of the push. Sixty boxes with μ = 1000 parted with up to
/// 14 m/s.
///
/// An overlap that no motion explains is not an impact, and parting from it should give no speed.
/// Recovering bodies therefore use the velocities of the push for their positions only, and have no
/// friction meanwhile, which could jam them. The relax passes then start from the velocities and
/// impulses before the push. Impacts keep the push: its softness damps a stack. Baumgarte contacts
/// have no relax passes, so that their bodies keep the speed of the push, but friction adds none.

namespace cs550 {

namespace {

bool is_dynamic(const WorldState& world, Index body) {
  return world.bodies[body].kind == BodyKind::Dynamic;
}

/// Bodies that move towards each other are in contact, at a positive separation, before they can
/// overlap. A misplaced pair remains one until it is free, however fast it parts.
/// @pre the pair overlaps by more than the spare margin: that of this step is at least as large
bool is_misplaced(const WorldState& world, std::size_t pair, Real h) {
  if (world.pairs.misplaced[pair]) return true;
  const PairSummary& summary = world.pairs.summaries[pair];
  return !world.pairs.touching[pair] &&
         summary.depth > contact_margin(world, summary.body_a, summary.body_b, h);
}

/// @returns whether there are any
bool find_misplaced_pairs(WorldState& world, Real h) {
  PairList& pairs = world.pairs;
  const Real spare = spare_margin(world);
  std::atomic<bool> any = false;
  for_pair_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      pairs.misplaced[i] = pairs.summaries[i].depth > spare && is_misplaced(world, i, h);
      if (pairs.misplaced[i]) any.store(true, std::memory_order_relaxed);
    }
  });
  return any;
}

/// A body that touches a recovering one recovers too: their impulses must stay equal and opposite.
void spread(WorldState& world) {
  std::vector<char>& recovers = world.recovery.recovers;
  std::vector<Index>& parent = world.recovery.parent;
  plant_forest(parent, world.bodies.size());
  for (const PairSummary& pair : world.pairs.summaries) {
    if (pair.points == 0) continue;
    if (!is_dynamic(world, pair.body_a) || !is_dynamic(world, pair.body_b)) continue;
    join(parent, pair.body_a, pair.body_b);
  }
  const auto bodies = static_cast<Index>(world.bodies.size());
  for (Index i = 0; i < bodies; ++i) {
    if (recovers[i]) recovers[root_of(parent, i)] = 1;
  }
  for (Index i = 0; i < bodies; ++i) recovers[i] = recovers[root_of(parent, i)];
}

/// The same angular momentum at the new orientation may belong to a larger energy. A push gives
/// none.
void return_momenta(RigidBody& body, const RigidBody& before) {
  body.linear_momentum = before.linear_momentum;
  body.angular_momentum = before.angular_momentum;
  refresh_velocity(body);
  const Real energy = turning_energy(before);
  const Real now = turning_energy(body);
  if (now <= energy) return;
  body.angular_momentum *= std::sqrt(energy / now);
  refresh_velocity(body);
}

}  // namespace

bool recovers(const WorldState& world, const ContactConstraint& constraint) {
  return world.recovery.recovers[constraint.body_a] || world.recovery.recovers[constraint.body_b];
}

void find_misplaced_bodies(WorldState& world, Real h) {
  world.recovery.recovers.assign(world.bodies.size(), 0);
  world.recovery.any = find_misplaced_pairs(world, h);
  if (!world.recovery.any) return;
  const PairList& pairs = world.pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs.misplaced[i]) continue;
    for (const Index body : {pairs.summaries[i].body_a, pairs.summaries[i].body_b}) {
      world.recovery.recovers[body] = is_dynamic(world, body);
    }
  }
  spread(world);
}

void begin_push(WorldState& world) {
  if (!world.recovery.any) return;
  read_back_impulses(world);
  world.recovery.bodies = world.bodies;
  world.recovery.constraints = world.constraints;
  world.mirrors.set_stale_numbers();
  for (ContactConstraint& constraint : world.constraints) {
    if (!recovers(world, constraint)) continue;
    constraint.friction = 0;
    constraint.tangent_impulse.setZero();
  }
}

void end_push(WorldState& world) {
  if (!world.recovery.any || world.constraints.empty()) return;
  read_back_impulses(world);
  world.mirrors.set_stale_numbers();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.recovery.recovers[i]) return_momenta(world.bodies[i], world.recovery.bodies[i]);
  }
  gather_solver_bodies(world);
  for (std::size_t i = 0; i < world.constraints.size(); ++i) {
    const ContactConstraint& before = world.recovery.constraints[i];
    if (!recovers(world, before)) continue;
    world.constraints[i].friction = before.friction;
    world.constraints[i].normal_impulse = before.normal_impulse;
    world.constraints[i].tangent_impulse = before.tangent_impulse;
  }
}

void return_friction(WorldState& world) {
  if (!world.recovery.any) return;
  read_back_impulses(world);
  world.mirrors.set_stale_numbers();
  for (std::size_t i = 0; i < world.constraints.size(); ++i) {
    world.constraints[i].friction = world.recovery.constraints[i].friction;
  }
}

void restart_after_push(WorldState& world, std::span<SolverBody> bodies, const ContactStep& step) {
  if (!world.recovery.any) return;
  read_back_impulses(world);
  world.mirrors.set_stale_numbers();
  for_constraints_of_contacts(world, [&](Index, std::span<const Index> places) {
    if (!recovers(world, world.constraints[places[0]])) return;
    const double before = impulse_energy(world, places);
    for (const Index place : places) prepare_contacts({&world.constraints[place], 1}, bodies, step);
    limit_impulse_energy(world, step, places, before);
    for (const Index place : places) {
      const ContactConstraint& constraint = world.constraints[place];
      warm_start(constraint, bodies[constraint.body_a], bodies[constraint.body_b]);
    }
  });
}

}  // namespace cs550
