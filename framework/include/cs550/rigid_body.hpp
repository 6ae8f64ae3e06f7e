#pragma once
/// @file rigid_body.hpp
/// The container of the engine: what a body is between two steps.

#include "cs550/math.hpp"

namespace cs550 {

/// What makes a body move.
enum class BodyKind : std::uint8_t {
  Static,     ///< never moves: no velocity, infinite mass
  Kinematic,  ///< moves by the velocities that its owner sets, is pushed by nothing: infinite mass
  Dynamic,    ///< moves by its momenta
};

/// A rigid body (Baraff 1997, §2–4). Its origin is its centre of mass.
///
/// For a dynamic body the **state** is {pose, linear_momentum, angular_momentum}. Velocities and
/// world_inverse_inertia are **derived** from it by refresh_velocity() and by nothing else, so that
/// momentum is conserved by construction. For a kinematic body the velocities are the state.
struct RigidBody {
  BodyKind kind = BodyKind::Dynamic;  ///< what makes it move

  Real mass = 1;                            ///< kg; 0 stands for infinite
  Real inverse_mass = 1;                    ///< 1/kg; 0 unless dynamic
  Mat3 inertia = Mat3::Identity();          ///< body frame, about the centre of mass (kg·m²)
  Mat3 inverse_inertia = Mat3::Identity();  ///< body frame; 0 unless dynamic

  Pose pose;                          ///< body → world
  Vec3 linear_momentum = {0, 0, 0};   ///< P, world (kg·m/s)
  Vec3 angular_momentum = {0, 0, 0};  ///< L about the centre of mass, world (kg·m²/s)
  Vec3 force = {0, 0, 0};             ///< gathered since the last step, world (N)
  Vec3 torque = {0, 0, 0};            ///< about the centre of mass, world (N·m)

  Vec3 linear_velocity = {0, 0, 0};           ///< v = P/m, world (m/s)
  Vec3 angular_velocity = {0, 0, 0};          ///< ω = R·I⁻¹·Rᵀ·L, world (rad/s)
  Mat3 world_inverse_inertia = Mat3::Zero();  ///< R·I⁻¹·Rᵀ
};

/// A dynamic body at rest.
/// @param mass kg, positive
/// @param inertia body frame, about the centre of mass, symmetric positive definite (kg·m²)
RigidBody make_dynamic_body(Real mass, const Mat3& inertia, const Pose& pose);

/// A static or kinematic body at rest.
RigidBody make_immovable_body(BodyKind kind, const Pose& pose);

/// Gives a body velocities (world frame; m/s, rad/s): sets P = m·v and L = R·I·Rᵀ·ω of a dynamic
/// body, whose velocities follow at the next refresh_velocity(); the velocities themselves of a
/// kinematic one; does nothing to a static one. Calls no lab function.
void set_velocity(RigidBody& body, const Vec3& linear, const Vec3& angular);

/// ½·m·v² + ½·ω·L of a dynamic body, 0 for the others (J). ω is computed afresh from L and the pose.
Real kinetic_energy(const RigidBody& body);

}  // namespace cs550
