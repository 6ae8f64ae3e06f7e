#pragma once
// Whether arcs of the unit sphere cross, in double precision and by lengths alone: no triple products,
// so that the mistakes of the lab cannot be here as well.

#include <algorithm>
#include <cmath>

#include "cs550/math.hpp"

namespace cs550::test {

using Vec3d = Eigen::Vector3d;

inline double angle(const Vec3d& a, const Vec3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How much longer the way from a to b is over p: zero on the arc, up to twice the distance off it.
inline double detour(const Vec3d& a, const Vec3d& p, const Vec3d& b) {
  return angle(a, p) + angle(p, b) - angle(a, b);
}

enum class Crossing { Yes, No, TooCloseToTell };

/// By lengths of arcs: the circles meet in two opposite points; is one of them on both arcs?
inline Crossing crossing_by_lengths(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                    const Vec3d& d) {
  const Vec3d meeting = a.cross(b).cross(c.cross(d)).normalized();
  Crossing result = Crossing::No;
  for (const double side : {1.0, -1.0}) {
    const Vec3d p = side * meeting;
    const double way = std::max(detour(a, p, b), detour(c, p, d));
    const double to_an_end = std::min({angle(p, a), angle(p, b), angle(p, c), angle(p, d)});
    if (way < 1e-3 && to_an_end < 1e-3) return Crossing::TooCloseToTell;
    if (way < 1e-6) result = Crossing::Yes;
  }
  return result;
}

}  // namespace cs550::test
