#pragma once
/// @file minkowski_difference.hpp
/// What a few points of the Minkowski difference of two bodies prove about the separation along every axis.

#include <span>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// The differences x − y of the points x of one body, the *other*, and y of a second, in the frame of
/// the latter. Where the bodies overlap, they contain the origin, and the separation along an axis is
/// minus the distance of the origin from the plane that supports them in the opposite direction.
class MinkowskiDifference {
 public:
  /// @param of_other, of_body the vertices at which climbs start
  MinkowskiDifference(const PosedShape& other, Index of_other, const PosedShape& body,
                      Index of_body);

  /// A point of the other body, in the frame of the second. Minus a point of the second it is a point of the
  /// difference.
  Vec3 from_other(const Vec3& point) const { return other_in_body_.to_world(point); }

  /// Whether points of the difference prove that no axis separates the bodies by more than the limit.
  ///
  /// Overlapping bodies: the points form a polytope around the ball of radius −limit about the origin. It is at
  /// first a pyramid over the base. A side that cuts the ball is replaced by a pyramid to the point of the
  /// difference that is farthest beyond it, a few times: the step of van den Bergen, *Proximity Queries and
  /// Penetration Depth Computation on 3D Game Objects* (GDC 2001). Bodies apart: the point of the base
  /// nearest to the origin is at most that far away.
  /// @param base a convex polygon of points of the difference, counter-clockwise about the normal
  /// @param normal unit, into the difference
  /// @pre the base is not farther than the limit along the normal. It is not measured again, since rounding would
  ///     matter for a small body on a large one.
  /// @returns false also if a few times do not suffice
  bool limits_separation(Real limit, std::span<const Vec3> base, const Vec3& normal);

 private:
  bool is_around_ball(Real radius, std::span<const Vec3> base, const Vec3& normal);
  bool is_beyond_ball(const Vec3& p, const Vec3& q, const Vec3& r, Real radius, int replacements);
  Vec3 farthest(const Vec3& direction);

  const HalfEdgeMesh& other_;
  const HalfEdgeMesh& body_;
  Pose other_in_body_;
  Real inner_radii_;
  Index of_other_;  ///< vertex of the last farthest point
  Index of_body_;   ///< vertex of the last farthest point
};

}  // namespace cs550
