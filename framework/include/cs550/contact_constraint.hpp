#pragma once
/// @file contact_constraint.hpp
/// A contact point as the contact solvers see it. Inside a substep the solvers work on two arrays only:
/// SolverBody[] and ContactConstraint[].

#include "cs550/solver_body.hpp"

namespace cs550 {

/// What a soft contact makes of an impulse: λ = −m_scale·m·(Jv + b) − λ_scale·λ_acc.
/// The defaults are a rigid contact.
struct Softness {
  Real bias_rate = 0;      ///< speed of recovery per metre of penetration (1/s)
  Real mass_scale = 1;     ///< m_scale: share of the mass that answers
  Real impulse_scale = 0;  ///< λ_scale: share of the accumulated impulse that is given back
};

/// A spring-damper of the given frequency as softness: with ω = 2π·hertz, a₁ = 2ζ + h·ω,
/// a₂ = h·ω·a₁, a₃ = 1/(1 + a₂): rate ω/a₁, mass scale a₂·a₃, impulse scale a₃ (Catto, *Solver2D*,
/// 2024). @param damping_ratio ζ, @param h substep (s)
Softness soft_contact(Real hertz, Real damping_ratio, Real h);

/// One contact point as the solver sees it. Geometry is that of the start of the step.
struct ContactConstraint {
  Index body_a = no_index;  ///< place in the array of SolverBody
  Index body_b = no_index;  ///< place in the array of SolverBody
  Vec3 n = {0, 0, 0};       ///< unit, A → B, world frame
  Vec3 u = {0, 0, 0};       ///< unit, first tangent, world frame; the second is v = n × u
  Vec3 r_a = {0, 0, 0};     ///< contact from A's centre of mass, world frame (m)
  Vec3 r_b = {0, 0, 0};     ///< contact from B's centre of mass, world frame (m)
  Real separation = 0;      ///< along n when the step began (m)
  Real friction = 0;        ///< μ
  Real restitution = 0;     ///< e

  Real normal_mass = 0;              ///< (JM⁻¹Jᵀ)⁻¹ along n (kg)
  Mat2 tangent_mass = Mat2::Zero();  ///< the same for u and v together (kg)
  Softness softness;                 ///< of the normal direction

  Real approach_velocity = 0;   ///< v_n⁰ before this substep's gravity and warm start (m/s)
  bool impact_handled = false;  ///< λ_n has been positive earlier in this step: v_n⁰ is spent

  Real normal_impulse = 0;        ///< accumulated λ_n ≥ 0 (N·s)
  Vec2 tangent_impulse = {0, 0};  ///< accumulated λ_u, λ_v (N·s)

  /// The second tangent, unit, world frame.
  Vec3 v() const;
};

}  // namespace cs550
