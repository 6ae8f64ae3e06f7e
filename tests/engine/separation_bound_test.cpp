// The bound that a contact point and two inner spheres give, against its largest value over many directions.

#include "engine/pairs/separation_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "helpers/random.hpp"

namespace cs550 {
namespace {

using test::Random;

/// The larger of the bound's two parts does not count: both hold, so the smaller one does.
Real bound_along(const SeparationBound& bound, const Vec3& n) {
  return std::min(bound.separation * n.dot(bound.normal), n.dot(bound.offset) - bound.inner_radii);
}

/// The largest bound over 20,000 directions, and over as many ever closer to the best of them.
Real largest_bound(const SeparationBound& bound, Random& random) {
  constexpr int directions = 20000;
  Vec3 best = bound.normal;
  for (const Real spread : {Real(2), Real(0.2), Real(0.02), Real(0.002)}) {
    const Vec3 middle = best;
    for (int i = 0; i < directions; ++i) {
      const Vec3 n = (middle + spread * random.unit_vector()).normalized();
      if (bound_along(bound, n) > bound_along(bound, best)) best = n;
    }
  }
  return bound_along(bound, best);
}

TEST(SeparationBound, OfOverlappingBodiesIsItsLargestValueOverAllDirections) {
  constexpr std::uint32_t seed = 41;
  Random random(seed);
  int with_both_parts = 0;
  for (int i = 0; i < 60; ++i) {
    const SeparationBound bound{random.unit_vector(), random.real(Real(-0.3), 0),
                                random.real(Real(0.2), Real(1.5)) * random.unit_vector(),
                                random.real(Real(0.2), 1)};
    const Real largest = largest_bound(bound, random);
    // The last directions are 2e-5 apart, and the bound changes by at most 1.5 times as much.
    constexpr Real resolution = Real(1e-4);
    EXPECT_FALSE(bound.stays_below(largest - resolution)) << "seed " << seed << ", bound " << i;
    EXPECT_TRUE(bound.stays_below(largest + resolution)) << "seed " << seed << ", bound " << i;
    if (largest < std::abs(bound.separation) - resolution) ++with_both_parts;
  }
  EXPECT_GT(with_both_parts, 10) << "too few bounds in which the spheres matter";
}

TEST(SeparationBound, OfBodiesApartIsTheDistanceOfTheTwoPoints) {
  const SeparationBound bound{Vec3::UnitX(), Real(0.25), {2, 0, 0}, 1};
  EXPECT_FALSE(bound.stays_below(Real(0.2499)));
  EXPECT_TRUE(bound.stays_below(Real(0.25)));
}

TEST(SeparationBound, OfStackedCubesIsNearlyTheDepthOfTheirFaces) {
  // Unit cubes that overlap by 1 cm. Sideways they overlap by 1 m, but a contact point alone allows
  // for a separation of 1 cm there: the spheres rule that out.
  const Real depth = Real(0.01);
  const SeparationBound bound{Vec3::UnitZ(), -depth, {0, 0, 1 - depth}, 1};
  EXPECT_TRUE(bound.stays_below(Real(0.99) * -depth));
  EXPECT_FALSE(bound.stays_below(Real(1.01) * -depth));
}

}  // namespace
}  // namespace cs550
