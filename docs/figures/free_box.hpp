#pragma once
/// @file free_box.hpp
/// The box that most figures of free rotation are about: half-extents 0.2, 0.5 and 1 m.

#include "cs550/integration.hpp"

namespace cs550::book {

inline constexpr Real frame = Real(1) / 60;  ///< s

/// A box of density 1 that spins. @param spin body frame (rad/s)
inline RigidBody free_box(const Vec3& spin, const Vec3& half_extents = {Real(0.2), Real(0.5), 1}) {
  const Vec3 squares = half_extents.cwiseProduct(half_extents);
  const Real mass = 8 * half_extents.prod();
  const Vec3 diagonal = mass / 3 * (Vec3::Constant(squares.sum()) - squares);
  RigidBody body = make_dynamic_body(mass, Mat3(diagonal.asDiagonal()), {});
  set_velocity(body, Vec3::Zero(), spin);
  refresh_velocity(body);
  return body;
}

/// One step of free rotation.
inline void turn(RigidBody& body, Real h, RotationMethod method) {
  integrate_pose(body, h, method);
  refresh_velocity(body);
}

}  // namespace cs550::book
