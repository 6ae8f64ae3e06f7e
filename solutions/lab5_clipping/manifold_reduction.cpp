/// @file manifold_reduction.cpp
/// Lab 5, reference, L5.5: four points that hold a body nearly as well as all of them.

#include <algorithm>
#include <cmath>

#include "cs550/clipping.hpp"

namespace cs550 {

namespace {

/// Twice the area of a triangle of contact points: positive if it runs counter-clockwise about the
/// normal.
Real doubled_area(const ContactPoint& p, const ContactPoint& q, const ContactPoint& r,
                  const Vec3& normal) {
  return normal.dot((q.anchor_a - p.anchor_a).cross(r.anchor_a - p.anchor_a));
}

/// The factor by which a point counts: 1 if it touches, less the wider its gap.
Real weight(const ContactPoint& p, Real margin) {
  if (p.separation <= 0) return 1;
  return 1 / (1 + gap_penalty * p.separation / margin);
}

/// The point with the largest measure; the first of several equal ones.
template <class Measure>
const ContactPoint& largest(std::span<const ContactPoint> points, Measure measure) {
  const ContactPoint* best = &points.front();
  Real most = measure(*best);
  for (const ContactPoint& p : points.subspan(1)) {
    const Real size = measure(p);
    if (size <= most) continue;
    best = &p;
    most = size;
  }
  return *best;
}

}  // namespace

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    std::span<const ContactPoint> points, const Vec3& normal, Real margin) {
  StaticVector<ContactPoint, max_manifold_points> kept;
  if (points.size() <= max_manifold_points) {
    for (const ContactPoint& point : points) kept.push_back(point);
    return kept;
  }

  const ContactPoint& deepest =
      largest(points, [](const ContactPoint& p) { return -p.separation; });
  kept.push_back(deepest);

  const auto distance = [&](const ContactPoint& p) {
    return weight(p, margin) * normal.cross(p.anchor_a - deepest.anchor_a).norm();
  };
  const ContactPoint& farthest = largest(points, distance);
  if (distance(farthest) == 0) return kept;  // all points coincide
  kept.push_back(farthest);

  const auto triangle_area = [&](const ContactPoint& p) {
    return weight(p, margin) * std::abs(doubled_area(deepest, farthest, p, normal));
  };
  const ContactPoint& third = largest(points, triangle_area);
  if (triangle_area(third) == 0) return kept;  // all points on one line
  kept.push_back(third);

  const bool counter_clockwise = doubled_area(deepest, farthest, third, normal) > 0;
  const ContactPoint& second = counter_clockwise ? farthest : third;
  const ContactPoint& last = counter_clockwise ? third : farthest;
  const auto added_area = [&](const ContactPoint& p) {
    return weight(p, margin) * std::max({doubled_area(second, deepest, p, normal),
                                         doubled_area(last, second, p, normal),
                                         doubled_area(deepest, last, p, normal)});
  };
  const ContactPoint& fourth = largest(points, added_area);
  if (added_area(fourth) > 0) kept.push_back(fourth);
  return kept;
}

}  // namespace cs550
