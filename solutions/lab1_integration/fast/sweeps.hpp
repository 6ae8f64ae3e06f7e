#pragma once
/// @file sweeps.hpp
/// The sweeps of a substep over all bodies, eight at a time. Two source files include it, one for each
/// width of register.

#include <span>

#include "sweeps_in_lanes.hpp"
#include "wide_momenta.hpp"
#include "wide_turn.hpp"

namespace cs550::CS550_LANES {

/// Calls `visit(indices, count)` with eight dynamic bodies that are awake at a time, at last with fewer.
template <class Visit>
void for_moving_bodies(std::span<const RigidBody> bodies, const Visit& visit) {
  std::array<std::size_t, lane_count> indices{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].kind != BodyKind::Dynamic || bodies[i].asleep) continue;
    indices[count++] = i;
    if (count < lane_count) continue;
    visit(indices, count);
    count = 0;
  }
  if (count > 0) visit(indices, count);
}

/// The elements of an array at these indices; an idle one in the other lanes.
template <class T>
PerLane<T> at(std::span<T> items, const std::array<std::size_t, lane_count>& indices,
              std::size_t count, T& idle) {
  PerLane<T> lanes;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    lanes[lane] = lane < count ? &items[indices[lane]] : &idle;
  }
  return lanes;
}

/// add_momentum_changes().
[[gnu::flatten]] void add_momentum_changes(std::span<RigidBody> bodies,
                                           std::span<const SolverBody> solver_bodies) {
  RigidBody idle;
  const SolverBody idle_solver_body;
  for_moving_bodies(bodies, [&](const auto& indices, std::size_t count) {
    const PerLane<RigidBody> lanes = at(bodies, indices, count, idle);
    WideMomenta body(lanes);
    if (body.add_change(at(solver_bodies, indices, count, idle_solver_body))) body.store(lanes);
  });
}

/// integrate_poses() for dynamic bodies with the implicit midpoint.
[[gnu::flatten]] void turn_dynamic_bodies(std::span<RigidBody> bodies,
                                          std::span<SolverBody> solver_bodies, Real h) {
  RigidBody idle;
  SolverBody idle_solver_body;
  for_moving_bodies(bodies, [&](const auto& indices, std::size_t count) {
    const PerLane<RigidBody> lanes = at(bodies, indices, count, idle);
    const WideTurn before(lanes);
    count_displacements(before, h, at(solver_bodies, indices, count, idle_solver_body));
    const WideTurned after = turned(before, h);
    if (all(keeps_energy(before, after))) {
      store(before, after, lanes);
    } else {
      for (std::size_t lane = 0; lane < count; ++lane) {
        turn_and_move(*lanes[lane], h, RotationMethod::ImplicitMidpoint);
      }
    }
  });
}

}  // namespace cs550::CS550_LANES
