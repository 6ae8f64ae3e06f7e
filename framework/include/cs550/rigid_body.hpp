#pragma once
/// @file rigid_body.hpp
/// The rigid body: its state between two steps.

#include "cs550/math.hpp"

namespace cs550 {

/// How a body moves.
enum class BodyKind : std::uint8_t {
  Static,     ///< never moves: no velocity, infinite mass
  Kinematic,  ///< moves at the velocity that its owner sets, unaffected by forces: infinite mass
  Dynamic,    ///< moves according to its momenta
};

/// A rigid body (Baraff 1997, §2–4). Its origin is its centre of mass.
///
/// The **state** of a dynamic body is {pose, linear_momentum, angular_momentum}. Velocities and
/// world_inverse_inertia are **derived** from the state, by refresh_velocity() and nothing else, so
/// that momentum is conserved by construction: a world overwrites them in each step. The state of a
/// kinematic body is its pose and its velocities. Kind, mass and inertia stay as
/// make_dynamic_body() or make_immovable_body() set them.
struct RigidBody {
  BodyKind kind = BodyKind::Dynamic;  ///< how it moves
  bool asleep = false;  ///< set by the world: at rest, and skipped until something disturbs it

  Real mass = 1;                            ///< kg; 0 means infinite
  Real inverse_mass = 1;                    ///< 1/kg; 0 unless dynamic
  Mat3 inertia = Mat3::Identity();          ///< body frame, about the centre of mass (kg·m²)
  Mat3 inverse_inertia = Mat3::Identity();  ///< body frame; 0 unless dynamic

  Pose pose;                          ///< body → world
  Vec3 linear_momentum = {0, 0, 0};   ///< P, world (kg·m/s)
  Vec3 angular_momentum = {0, 0, 0};  ///< L about the centre of mass, world (kg·m²/s)
  Vec3 force = {0, 0, 0};             ///< accumulated since the last step, world (N)
  Vec3 torque = {0, 0, 0};            ///< accumulated, about the centre of mass, world (N·m)

  Vec3 linear_velocity = {0, 0, 0};           ///< v, of the centre of mass, world (m/s)
  Vec3 angular_velocity = {0, 0, 0};          ///< ω, world (rad/s)
  Mat3 world_inverse_inertia = Mat3::Zero();  ///< about the centre of mass, world (1/(kg·m²))
};

/// A dynamic body at rest.
/// @param mass kg, positive
/// @param inertia body frame, about the centre of mass, symmetric positive definite (kg·m²)
RigidBody make_dynamic_body(Real mass, const Mat3& inertia, const Pose& pose);

/// A static or kinematic body at rest.
RigidBody make_immovable_body(BodyKind kind, const Pose& pose);

/// Sets the velocities of a body (world frame; m/s, rad/s). For a dynamic body it sets P = m·v and
/// L = R·I·Rᵀ·ω, and the velocities follow at the next refresh_velocity(). For a kinematic body it
/// sets the velocities themselves. A static body is unchanged. Calls no lab function.
void set_velocity(RigidBody& body, const Vec3& linear, const Vec3& angular);

/// The kinetic energy ½·m·v² + ½·ω·L of a dynamic body, 0 for others (J). v and ω are recomputed
/// from the momenta and the pose.
Real kinetic_energy(const RigidBody& body);

}  // namespace cs550
