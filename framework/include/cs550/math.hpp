#pragma once
/// @file math.hpp
/// Basic types, used by every other header, and the conventions of the whole project.
///
/// **Conventions**
/// - right-handed axes, SI units (m, kg, s, rad);
/// - a quaternion `q` rotates from the body frame to the world frame;
/// - a contact normal `n` is unit length and points **from A to B**;
/// - the normal velocity `v_n = n·(v_B + ω_B × r_B − v_A − ω_A × r_A)` is negative when
///   approaching;
/// - a separation is negative when the bodies overlap;
/// - faces are counter-clockwise seen from outside, so their normals point outward.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "cs550/summation_order.hpp"

namespace cs550 {

/// The scalar of the engine.
using Real = float;

/// The index of an element (vertex, half-edge, face, body) in its array.
using Index = std::int32_t;

/// Stands for "no element".
inline constexpr Index no_index = -1;

/// Column vectors, square matrices and quaternions. They have no alignment requirements, so they
/// can be stored, copied and serialised as plain bytes. Their sums and products are bitwise equal on
/// every instruction set (summation_order.hpp).
/// @{
using Vec2 = Eigen::Matrix<Real, 2, 1, Eigen::DontAlign>;
using Vec3 = Eigen::Matrix<Real, 3, 1, Eigen::DontAlign>;
using Mat2 = Eigen::Matrix<Real, 2, 2, Eigen::DontAlign>;
using Mat3 = Eigen::Matrix<Real, 3, 3, Eigen::DontAlign>;
using Quat = Eigen::Quaternion<Real, Eigen::DontAlign>;
/// @}

/// π
inline constexpr Real pi = static_cast<Real>(3.14159265358979323846L);

/// The points x with `normal·x = offset`. The normal is unit length.
struct Plane {
  Vec3 normal = {0, 0, 1};  ///< unit
  Real offset = 0;          ///< distance from the origin along the normal (m)

  /// The signed distance of a point (m), positive on the side that the normal points to.
  Real distance(const Vec3& point) const { return normal.dot(point) - offset; }
};

/// Position and orientation of a body: `x_world = R(orientation)·x_body + position`.
struct Pose {
  Vec3 position = {0, 0, 0};        ///< of the body's origin, world frame (m)
  Quat orientation = {1, 0, 0, 0};  ///< unit, body → world; constructed from w, x, y, z

  /// The rotation matrix R, body → world.
  Mat3 rotation() const { return orientation.toRotationMatrix(); }
  /// Transforms a point between the body frame and the world frame (m).
  /// @{
  Vec3 to_world(const Vec3& point) const { return orientation * point + position; }
  Vec3 to_body(const Vec3& point) const { return orientation.conjugate() * (point - position); }
  /// @}

  /// Rotates a direction from the body frame to the world frame. The position has no influence.
  Vec3 rotate(const Vec3& direction) const { return orientation * direction; }
  /// Rotates a direction from the world frame to the body frame.
  Vec3 unrotate(const Vec3& direction) const { return orientation.conjugate() * direction; }
};

/// An axis-aligned box. Empty when constructed.
struct Bounds {
  Vec3 lower = {HUGE_VALF, HUGE_VALF, HUGE_VALF};     ///< the smallest coordinates (m)
  Vec3 upper = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};  ///< the largest coordinates (m)

  /// Extends the box to contain a point or another box.
  /// @{
  void include(const Vec3& point);
  void include(const Bounds& other);
  /// @}

  /// Whether the other box is inside this one or touches its boundary from inside.
  bool contains(const Bounds& other) const;
  /// Whether the boxes have at least one point in common.
  bool overlaps(const Bounds& other) const;
  /// The box enlarged by a margin on every side (m).
  Bounds expanded(Real margin) const;
  /// The centre (m).
  Vec3 center() const;
  /// The lengths of the sides (m).
  Vec3 extent() const;
};

/// Sine and cosine (rad), computed in double precision and rounded once. Those of float differ between
/// C libraries, by a last bit in one of a hundred angles.
/// @{
Real sine(Real angle);
Real cosine(Real angle);
/// @}

/// The unit quaternion of a rotation by |v| radians about v: exp(v/2) of the pure quaternion (0,
/// v).
/// @param v rotation vector (rad); zero gives the identity
Quat rotation_exp(const Vec3& v);

/// Some unit vector perpendicular to a unit vector n.
Vec3 any_perpendicular(const Vec3& n);

}  // namespace cs550
