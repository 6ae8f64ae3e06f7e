#pragma once
/// @file contact_constraint.hpp
/// A contact point as the contact solvers see it. Within a substep the solvers work on two arrays
/// only: SolverBody[] and ContactConstraint[].

#include "cs550/solver_body.hpp"

namespace cs550 {

/// The parameters of a soft constraint, with the impulse λ = −m_scale·m·(JV + b) − λ_scale·λ_acc.
/// The defaults describe a rigid contact.
struct Softness {
  Real bias_rate = 0;      ///< recovery speed per metre of penetration (1/s)
  Real mass_scale = 1;     ///< m_scale: fraction of the effective mass that takes part
  Real impulse_scale = 0;  ///< λ_scale: fraction of the accumulated impulse that is taken back
};

/// The softness of a damped spring (Catto, *Solver2D*, 2024). With ω = 2π·hertz, a₁ = 2ζ + h·ω,
/// a₂ = h·ω·a₁ and a₃ = 1/(1 + a₂), the bias rate is ω/a₁, the mass scale a₂·a₃ and the impulse
/// scale a₃.
/// @param hertz natural frequency of the spring (1/s)
/// @param damping_ratio ζ; 1 is critical
/// @param h substep (s)
Softness soft_contact(Real hertz, Real damping_ratio, Real h);

/// One contact point as the contact solvers see it. The geometry is that at the start of the step, unless a
/// thin body has turned far since: its levers then follow.
struct ContactConstraint {
  Index body_a = no_index;  ///< index in the array of SolverBody
  Index body_b = no_index;  ///< index in the array of SolverBody
  Vec3 n = {0, 0, 0};       ///< unit, A → B, world frame
  Vec3 u = {0, 0, 0};       ///< unit, first tangent, world frame; the second is v = n × u
  Vec3 r_a = {0, 0, 0};     ///< contact from A's centre of mass, world frame (m)
  Vec3 r_b = {0, 0, 0};     ///< contact from B's centre of mass, world frame (m)
  Real separation = 0;      ///< along n, without the bodies' displacements (m)
  Real friction = 0;        ///< μ
  Real restitution = 0;     ///< e

  Real normal_mass = 0;              ///< (JM⁻¹Jᵀ)⁻¹ along n (kg)
  Mat2 tangent_mass = Mat2::Zero();  ///< the same for u and v together, 2 × 2 (kg)
  Softness softness;                 ///< of the normal constraint

  Real approach_velocity = 0;   ///< v_n⁰, before the substep's gravity and warm start (m/s)
  bool impact_handled = false;  ///< λ_n has been positive before, so v_n⁰ must not be used again

  Real normal_impulse = 0;        ///< accumulated λ_n ≥ 0 (N·s)
  Vec2 tangent_impulse = {0, 0};  ///< accumulated λ_u, λ_v (N·s)

  /// The second tangent, unit, world frame.
  Vec3 v() const;
  /// Sets impact_handled if λ_n is positive; never clears it.
  void mark_impact();
};

}  // namespace cs550
