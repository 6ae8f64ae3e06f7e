#pragma once
/// @file integration.hpp
/// **Lab 1:** How a body moves: forces change momenta, momenta give velocities, velocities turn
/// and carry the body. Document §1; Baraff, *Rigid Body Simulation I* (1997), §2–4.

#include "cs550/rigid_body.hpp"

namespace cs550 {

/// How integrate_pose() turns a body over one step.
enum class RotationMethod : std::uint8_t {
  Explicit,          ///< q += ½·h·(0, ω)·q with ω at the start: simple, and gains energy
  ImplicitMidpoint,  ///< ω at the middle of the step: keeps the energy bounded
};

/// **L1.1** Adds a force that acts at a point to what the body has gathered since the last step:
/// F += f, τ += (p − x) × f. Changes nothing else. Static and kinematic bodies ignore forces when
/// they are integrated, not here.
/// @param force world frame (N)
/// @param point where it acts, world frame (m)
void add_force(RigidBody& body, const Vec3& force, const Vec3& point);

/// **L1.2** Applies an impulse, a force whose effect is immediate: P += j, L += (p − x) × j.
/// The derived velocities follow. A body that is not dynamic is not changed.
/// @param impulse world frame (N·s)
/// @param point where it acts, world frame (m)
void apply_impulse(RigidBody& body, const Vec3& impulse, const Vec3& point);

/// **L1.3** The inverse inertia in the world frame, R·I⁻¹·Rᵀ (1/(kg·m²)).
Mat3 world_inverse_inertia(const RigidBody& body);

/// **L1.4** Derives velocities from momenta at the present pose: v = P/m, ω = R·I⁻¹·Rᵀ·L, and
/// stores R·I⁻¹·Rᵀ. A kinematic body keeps its velocities; a static one has none.
void refresh_velocity(RigidBody& body);

/// **L1.5** Lets the gathered force and torque act for a time h: P += F·h, L += τ·h, for a dynamic
/// body. Does not clear them (a step may have several substeps) and does not refresh velocities.
/// @param h time (s)
void integrate_momentum(RigidBody& body, Real h);

/// **L1.6** (explicit) and **L1.7** (implicit midpoint) Moves the body for a time h:
/// x += v·h and the orientation by the method, normalised. The momenta stay as they are. Velocities
/// are read as refresh_velocity() left them, and are out of date afterwards: the caller refreshes.
///
/// Implicit midpoint solves w = ω(exp(½·h·w)·q) by three fixed-point iterations from w = ω(q), where
/// ω(q) = R(q)·I⁻¹·R(q)ᵀ·L, then q ← exp(h·w)·q. L is exact in both methods; only the midpoint keeps
/// ω consistent with q over the step (Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// §VII.5). A kinematic body turns by its constant ω; a static one stays.
/// @param h time (s)
void integrate_pose(RigidBody& body, Real h, RotationMethod method);

}  // namespace cs550
