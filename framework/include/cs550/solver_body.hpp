#pragma once
/// @file solver_body.hpp
/// A rigid body as the contact solvers see it.

#include "cs550/math.hpp"

namespace cs550 {

/// All that a contact solver sees of a body. Immovable bodies have zero inverse mass and inertia.
struct SolverBody {
  Vec3 v = {0, 0, 0};                         ///< of the centre of mass, world (m/s)
  Vec3 w = {0, 0, 0};                         ///< ω, world (rad/s)
  Real inverse_mass = 0;                      ///< 1/kg
  Mat3 world_inverse_inertia = Mat3::Zero();  ///< 1/(kg·m²)
  Vec3 delta_position = {0, 0, 0};            ///< moved since the step began (m)
  Vec3 delta_rotation = {0, 0, 0};            ///< turned since then: Σ h·ω (rad)

  /// Changes the velocities as an impulse at an offset from the centre of mass does.
  /// @param impulse world frame (N·s)
  /// @param r where it acts, from the centre of mass, world frame (m)
  void apply(const Vec3& impulse, const Vec3& r);
};

}  // namespace cs550
