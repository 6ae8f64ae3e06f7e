#pragma once
/// @file math.hpp
/// The vocabulary of every other header, and the conventions of the whole project.
///
/// **Conventions**, everywhere:
/// - right-handed axes, SI units (m, kg, s, rad);
/// - a quaternion `q` rotates body to world;
/// - a contact normal `n` is unit length and points **from A to B**;
/// - the normal velocity `v_n = n·(v_B + ω_B × r_B − v_A − ω_A × r_A)` is negative when approaching;
/// - a separation is negative in penetration;
/// - faces are counter-clockwise seen from outside, so their normals point outward.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

namespace cs550 {

/// The scalar of the engine.
using Real = float;

/// Names an element (vertex, half-edge, face, body) by its place in an array.
using Index = std::int32_t;

/// The index of nothing.
inline constexpr Index no_index = -1;

/// Columns, square matrices and quaternions. They carry no alignment demands: they may be stored,
/// copied and serialised as plain bytes, and they give the same bits whatever the instruction set.
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
  Real offset = 0;          ///< m, along the normal from the origin

  /// Signed distance of a point (m), positive on the side to which the normal points.
  Real distance(const Vec3& point) const;
};

/// Where a body is: `x_world = R(orientation)·x_body + position`.
struct Pose {
  Vec3 position = {0, 0, 0};        ///< of the body's origin, in the world (m)
  Quat orientation = {1, 0, 0, 0};  ///< unit length, body to world; given as w, x, y, z

  /// R, body to world.
  Mat3 rotation() const;
  /// The same point in the other frame (m).
  /// @{
  Vec3 to_world(const Vec3& point) const;
  Vec3 to_body(const Vec3& point) const;
  /// @}

  /// Turns a direction from body to world; directions ignore the position.
  Vec3 rotate(const Vec3& direction) const;
  /// Turns a direction from world to body.
  Vec3 unrotate(const Vec3& direction) const;
};

/// An axis-aligned box; empty until it includes a point.
struct Bounds {
  Vec3 lower = {HUGE_VALF, HUGE_VALF, HUGE_VALF};     ///< the smallest coordinates (m)
  Vec3 upper = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};  ///< the largest coordinates (m)

  /// Grows until it holds the point or the box.
  /// @{
  void include(const Vec3& point);
  void include(const Bounds& other);
  /// @}

  /// Whether the other box lies inside, boundary included.
  bool contains(const Bounds& other) const;
  /// Whether the boxes share a point.
  bool overlaps(const Bounds& other) const;
  /// With a margin added on every side (m).
  Bounds expanded(Real margin) const;
  /// The middle (m).
  Vec3 center() const;
  /// The lengths of the sides (m).
  Vec3 extent() const;
};

/// The unit quaternion of a turn by |v| radians about v: exp(v/2) of the pure quaternion (0, v).
/// @param v rotation vector (rad); zero gives the identity
Quat rotation_exp(const Vec3& v);

/// A unit vector perpendicular to a unit vector n, chosen away from n's largest components.
Vec3 any_perpendicular(const Vec3& n);

}  // namespace cs550
