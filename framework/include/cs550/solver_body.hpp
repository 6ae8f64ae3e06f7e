#pragma once
/// @file solver_body.hpp
/// A rigid body as the contact solvers see it.

#include "cs550/math.hpp"

namespace cs550 {

/// The part of a body that contact solvers use. An immovable body has an inverse mass and an
/// inverse inertia of zero, so that impulses leave it unchanged.
struct SolverBody {
  Vec3 v = {0, 0, 0};                         ///< of the centre of mass, world (m/s)
  Vec3 w = {0, 0, 0};                         ///< ω, world (rad/s)
  Real inverse_mass = 0;                      ///< 1/kg
  Mat3 world_inverse_inertia = Mat3::Zero();  ///< 1/(kg·m²)
  Vec3 delta_position = {0, 0, 0};            ///< displacement since the step began (m)
  Vec3 delta_rotation = {0, 0, 0};            ///< rotation since the step began: Σ h·ω (rad)

  /// Applies an impulse: changes v and w.
  /// @param impulse world frame (N·s)
  /// @param r point of application relative to the centre of mass, world frame (m)
  void apply(const Vec3& impulse, const Vec3& r);
};

}  // namespace cs550
