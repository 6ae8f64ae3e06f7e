#pragma once
/// @file integration.hpp
/// **Lab 1:** Integration: forces change momenta, momenta determine velocities, velocities move and
/// rotate the body. Document §1; Baraff, *Rigid Body Simulation I* (1997), §2–4.

#include "cs550/rigid_body.hpp"

namespace cs550 {

/// How integrate_pose() rotates a body over one step.
enum class RotationMethod : std::uint8_t {
  Explicit,          ///< uses ω at the start of the step: simple, but gains energy
  ImplicitMidpoint,  ///< uses ω at the middle of the step: keeps the energy bounded
};

/// **L1.1** Adds a force, and its torque about the centre of mass, to the force and torque
/// accumulated since the last step. Changes nothing else. Forces on static and kinematic bodies are
/// accumulated too and ignored by the integration.
/// @param force world frame (N)
/// @param point point of application, world frame (m)
void add_force(RigidBody& body, const Vec3& force, const Vec3& point);

/// **L1.2** Applies an impulse to a dynamic body: changes both momenta at once and updates the
/// derived velocities. Accumulated forces are not involved. A body that is not dynamic is
/// unchanged.
/// @param impulse world frame (N·s)
/// @param point point of application, world frame (m)
void apply_impulse(RigidBody& body, const Vec3& impulse, const Vec3& point);

/// **L1.3** The inverse inertia in the world frame at the current orientation (1/(kg·m²)). Zero for
/// a body that is not dynamic.
Mat3 world_inverse_inertia(const RigidBody& body);

/// **L1.4** Derives linear and angular velocity from the momenta at the current pose, and stores
/// the inverse inertia in the world frame for every kind of body. A kinematic body keeps its
/// velocities; those of a static body become zero.
void refresh_velocity(RigidBody& body);

/// **L1.5** Integrates the accumulated force and torque of a dynamic body over a time h. Does not
/// clear them, because a step may have several substeps, and does not refresh the velocities.
/// @param h time (s)
void integrate_momentum(RigidBody& body, Real h);

/// **L1.6** (explicit) and **L1.7** (implicit midpoint) Moves and rotates a body over a time h. The
/// orientation stays normalised and the momenta stay constant. The velocities are used as
/// refresh_velocity() left them; afterwards they are out of date, and the caller refreshes them.
/// A kinematic body rotates with constant ω, a static body does not move.
///
/// Both methods conserve L exactly. Only the implicit midpoint keeps ω consistent with the
/// orientation throughout the step: its error is of second order in h, and the energy stays bounded
/// (Hairer, Lubich & Wanner, *Geometric Numerical Integration*, §VII.5).
/// @param h time (s)
void integrate_pose(RigidBody& body, Real h, RotationMethod method);

}  // namespace cs550
