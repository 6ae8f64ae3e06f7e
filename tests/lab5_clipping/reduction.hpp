#pragma once
/// @file reduction.hpp
/// Random contact polygons, and the best four points by brute force.

#include <algorithm>
#include <vector>

#include "lab5_clipping/contacts.hpp"
#include "lab5_clipping/pictures.hpp"

namespace cs550::test {

/// The area that reduce_manifold() must keep. Over 120,000 random polygons the algorithm of the
/// header kept at least 71 % of the best four points' area, 98 % on average; a recipe that takes
/// one point on each side of the longest line falls to 43 % and 92 %.
inline constexpr double least_share = 0.65;
inline constexpr double mean_share = 0.96;

/// Points in convex position on a tilted ellipse, deeper towards a random side. As on an incident face of A,
/// an anchor is off the plane of the ellipse by its separation.
struct ContactRing {
  Vec3 normal;
  std::vector<ContactPoint> points;

  ContactRing(Random& random, Real size) : normal(random.unit_vector()) {
    const Vec3 u = any_perpendicular(normal);
    const Vec3 v = normal.cross(u);
    const Real width = size * random.real(Real(0.1), 1);
    const Real height = size * random.real(Real(0.1), 1);
    const Real arc = random.integer(0, 3) == 0 ? pi : 2 * pi;  // a quarter of them are half discs
    const Vec3 tilt = random.point_in_box(Vec3::Constant(Real(0.2)));
    std::vector<Real> angles(random.integer(5, 14));
    for (Real& angle : angles) angle = random.real(0, arc);
    std::sort(angles.begin(), angles.end());
    for (const Real angle : angles) {
      ContactPoint point;
      point.anchor_a = width * std::cos(angle) * u + height * std::sin(angle) * v;
      point.separation = tilt.dot(point.anchor_a) - size;
      point.anchor_a -= point.separation * normal;
      point.feature = {FeatureId::Kind::Edges, static_cast<Index>(points.size()), 0};
      points.push_back(point);
    }
  }

  const ContactPoint& deepest() const {
    return *std::min_element(points.begin(), points.end(), [](const auto& p, const auto& q) {
      return p.separation < q.separation;
    });
  }
};

/// A face of height 2 · size that touches along an edge of 0.4 · size; its other 4 to 8 corners are
/// across a gap, those at the top at the margin. The distances of these from the deepest point,
/// multiplied by the factor of the header, are at most 0.36 · size: less than the edge.
struct RestingEdge {
  Vec3 normal;
  std::vector<ContactPoint> points;  ///< counter-clockwise from a random one

  RestingEdge(Random& random, Real size, Real margin) : normal(random.unit_vector()) {
    const Vec3 u = any_perpendicular(normal);
    const Vec3 v = normal.cross(u);
    const auto add = [&](Real x, Real y, Real separation) {
      ContactPoint point;
      point.anchor_a = size * (x * u + y * v);
      point.separation = separation;
      point.feature = {FeatureId::Kind::Edges, static_cast<Index>(points.size()), 0};
      points.push_back(point);
    };
    add(0, 0, Real(-1e-3) * margin);
    add(Real(0.4), 0, 0);
    std::vector<Real> angles(random.integer(4, 8));
    for (Real& angle : angles) angle = random.real(-pi / 6, 7 * pi / 6);
    std::sort(angles.begin(), angles.end());
    for (const Real angle : angles) {
      const Real y = 1 + std::sin(angle);
      add(Real(0.2) + std::cos(angle) / 2, y, margin * y / 2);
    }
    std::rotate(points.begin(), points.begin() + random.integer(0, 3), points.end());
  }
};

template <class Points>
double ring_area(const Points& points, const Vec3& normal) {
  std::vector<Point> places;
  places.reserve(points.size());
  for (const ContactPoint& point : points) places.push_back(point.anchor_a.template cast<double>());
  return area_of(places, normal.cast<double>());
}

/// The largest area of four of the points, one of which is the deepest.
inline double best_area_of_four(const ContactRing& ring) {
  const ContactPoint& deepest = ring.deepest();
  double best = 0;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.points.size(); ++j) {
      for (std::size_t k = j + 1; k < ring.points.size(); ++k) {
        const std::vector<ContactPoint> four{deepest, ring.points[i], ring.points[j],
                                             ring.points[k]};
        best = std::max(best, ring_area(four, ring.normal));
      }
    }
  }
  return best;
}

/// Checks random polygons of one size.
inline void require_good_reductions(Story story, Random& random, Real size, int count) {
  story.given("size", size, "m");
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const ContactRing ring(random, size);
    const auto kept = reduce_manifold(ring.points, ring.normal, size / 10);
    const double best = best_area_of_four(ring);
    const double share = ring_area(kept, ring.normal) / best;
    Story here = story;
    here.given("points", ring.points.size());
    here.picture([&] {
      return reduction_picture(ring.points, {kept.begin(), kept.end()}, ring.normal);
    });
    require(here.expect_at_most("points kept", kept.size(), max_manifold_points));
    require(here.expect_at_least("area, as a share of what the best four points have", share,
                                 least_share));
    sum += share;
  }
  require(story.expect_at_least("share, on average", sum / count, mean_share));
}

}  // namespace cs550::test
