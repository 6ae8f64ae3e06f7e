#include <algorithm>
#include <cmath>

#include "engine/body_sweeps.hpp"

/// @file turn_guard.cpp
/// The implicit midpoint is solved by fixed-point iteration, which contracts only while
/// ½·h·|ω|·I_max/I_min < 1. In substeps of 1/480 s a needle of 1 : 50 breaks that at 0.8 rad/s, and
/// the lost solution can have any energy up to L²/(2·I_min). A free turn keeps its energy: that is the
/// guard. What a turn may gain, a spinning body gains in every substep, so smaller turns begin early, and
/// for losses too: gains alone would be a bias.

namespace cs550 {

namespace {

constexpr int smaller_turns = 8;

void turn(RigidBody& body, Real h, RotationMethod method, int turns) {
  for (int i = 0; i < turns; ++i) {
    integrate_pose(body, h / static_cast<Real>(turns), method);
    refresh_velocity(body);
  }
}

}  // namespace

/// That of a thin needle rounds to less than nothing where its smallest inverse inertia is below the rounding of the largest.
Real turning_energy(const RigidBody& body) {
  return std::max(Real(0.5) * body.angular_velocity.dot(body.angular_momentum), Real(0));
}

void turn_and_move(RigidBody& body, Real h, RotationMethod method) {
  const Real energy = turning_energy(body);
  const Pose start = body.pose;
  turn(body, h, method, 1);
  const Real change = std::abs(turning_energy(body) - energy);
  if (method == RotationMethod::Explicit || change <= allowed_change * energy) return;

  body.pose = start;
  refresh_velocity(body);
  turn(body, h, method, smaller_turns);
  const Real gained = turning_energy(body);
  if (gained <= (1 + allowed_change) * energy) return;
  // Better to lose momentum, which friction soon does anyway, than to throw the body out of the
  // scene.
  body.angular_momentum *= std::sqrt(energy / gained);
  refresh_velocity(body);
}

}  // namespace cs550
