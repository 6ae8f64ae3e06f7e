#pragma once
/// @file separation_bound.hpp
/// What a contact point proves about the separation along every axis.

#include <algorithm>
#include <cmath>

#include "cs550/math.hpp"

namespace cs550 {

/// An upper bound of the separation s(n) = min over B of n·b − max over A of n·a in every direction n:
/// - A point of A and a point of B are apart by separation·normal, so s(n) ≤ separation·(n·normal).
/// - Each body contains a sphere about its origin, so s(n) ≤ n·offset − inner_radii.
///
/// The first is sharp near the normal, the second away from it. All vectors are in one frame.
struct SeparationBound {
  Vec3 normal;       ///< unit, from A to B
  Real separation;   ///< of the two points along the normal, negative where the bodies overlap (m)
  Vec3 offset;       ///< of B's origin from A's (m)
  Real inner_radii;  ///< of the spheres, added (m)

  /// Whether the bound is at most `limit` in every direction. For bodies apart the spheres are not
  /// needed.
  bool stays_below(Real limit) const {
    if (separation >= 0) return separation <= limit;

    // The first bound exceeds the limit in the directions with n·normal < cosine.
    const Real cosine = limit / separation;
    if (cosine < -1) return true;
    return reach(std::min(cosine, Real(1))) - inner_radii <= limit;
  }

 private:
  /// The largest n·offset of the directions with n·normal ≤ cosine.
  Real reach(Real cosine) const {
    const Real distance = offset.norm();
    const Real along = offset.dot(normal);
    if (along <= cosine * distance) return distance;
    const Real across = std::sqrt(std::max(Real(0), distance * distance - along * along));
    return along * cosine + across * std::sqrt(1 - cosine * cosine);
  }
};

}  // namespace cs550
