#pragma once
// Whether arcs of the unit sphere cross, in double precision and from lengths only. There are no
// triple products, so that it cannot contain the mistakes of the lab.

#include <algorithm>
#include <cmath>

#include "cs550/math.hpp"

namespace cs550::test {

using Vec3d = Eigen::Vector3d;

inline double angle(const Vec3d& a, const Vec3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The detour from a to b over p: zero on the arc, at most twice the distance beside it.
inline double detour(const Vec3d& a, const Vec3d& p, const Vec3d& b) {
  return angle(a, p) + angle(p, b) - angle(a, b);
}

enum class Crossing { Yes, No, TooCloseToTell };

/// The great circles meet in two opposite points. Checks by lengths whether one is on both arcs.
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
