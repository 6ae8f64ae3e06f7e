#pragma once
/// @file diagnostics.hpp
/// Energy, momentum and velocities of a world, and what to do when they are lost.

#include <vector>

#include "cs550/world.hpp"

namespace cs550 {

/// Mechanical energy of the dynamic bodies (J).
struct Energy {
  double kinetic = 0;    ///< ½·m·v² + ½·ω·L
  double potential = 0;  ///< −m·g·x, zero at the world's origin
  /// KE + PE − ½·h·m·g·v_up, which the semi-implicit step of length h conserves in free fall: each step
  /// loses ½·m·g²·h² of KE + PE, and v_up falls by g·h.
  double invariant = 0;

  /// KE + PE.
  double total() const { return kinetic + potential; }
};

/// The mechanical energy of a world. @param h substep (s), needed for the invariant
Energy energy(const World& world, Real h);

/// Σ P of the dynamic bodies, world frame (kg·m/s).
Eigen::Vector3d linear_momentum(const World& world);

/// Σ L + x × P of the dynamic bodies about the world's origin (kg·m²/s).
Eigen::Vector3d angular_momentum(const World& world);

/// Velocities of a body, world frame.
struct Velocities {
  Vec3 linear;   ///< v (m/s)
  Vec3 angular;  ///< ω (rad/s)
};

/// The velocities of a dynamic body that follow from its momenta and its pose. Its own velocities
/// are those that the last step derived, and 0 before the first step. Calls no lab function.
Velocities velocities_from_momenta(const RigidBody& body);

/// Whether all poses, momenta, squares of linear momenta and kinetic energies are finite. It does
/// not check pending forces and torques, nor the velocities of kinematic bodies.
bool is_finite(const World& world);

/// Repeats a step with checks after every stage. @returns the stages that broke a promise, each with
/// the body and the step; at least one if the step loses the finite state
/// @param before the world before that step
/// @param h step (s)
std::vector<StageProblem> find_broken_stages(World before, Real h);

}  // namespace cs550
