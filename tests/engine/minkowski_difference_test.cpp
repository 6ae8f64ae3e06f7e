// The points that limit the separation of two bodies, against it by brute force in double precision.

#include "engine/pairs/minkowski_difference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "cs550/hill_climbing.hpp"
#include "cs550/separating_axis.hpp"
#include "engine/test_bodies.hpp"
#include "helpers/exact_separation.hpp"

namespace cs550 {
namespace {

using namespace test;

/// The proof that begins with a face of A, seen from the vertex of B deepest behind it.
bool proves(const PosedShape& a, const PosedShape& b, const FaceQuery& query, Real radius) {
  MinkowskiDifference difference(b, query.vertex, a, 0);
  const Vec3 deepest = difference.from_other(b.mesh().vertex(query.vertex));
  std::vector<Vec3> base;
  for (const Index edge : face_edges(a.mesh(), query.face)) {
    base.push_back(deepest - a.mesh().vertex(a.mesh().edge(edge).vertex));
  }
  return difference.limits_separation(-radius, base, a.mesh().face(query.face).plane.normal);
}

/// A hull at the origin, and one that overlaps it by a few per cent of its size.
struct OverlappingHulls {
  ShapePtr shape_a, shape_b;
  PosedShape a, b;

  explicit OverlappingHulls(Random& random)
      : shape_a(random_hull(random, 20, {Real(0.6), Real(0.5), Real(0.4)})),
        shape_b(random_hull(random, 12, {Real(0.5), Real(0.5), Real(0.3)})) {
    a = {shape_a.get(), {Vec3::Zero(), random.orientation()}};
    b = {shape_b.get(), {3 * random.unit_vector(), random.orientation()}};
    const Real wanted = random.real(Real(0.002), Real(0.03));
    Real separation = 1;
    while (separation > Real(-0.9) * wanted) {
      const SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
      separation = axis.separation;
      b.pose.position -= (separation + wanted) * axis.axis;
    }
  }

  double depth() const {
    return -best_separations(ExactBody(a, Vec3::Zero()), ExactBody(b, Vec3::Zero())).largest();
  }
};

TEST(MinkowskiDifference, OfOverlappingCubesIsAroundTheBallThatTouchesItsNearestFace) {
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  const Real lowest = Real(-0.02);
  const Real leftmost = Real(-0.01);
  const PosedShape a{cube.get(), {}};
  const PosedShape b{cube.get(), {{1 + leftmost, Real(-0.2), 1 + lowest}, Quat::Identity()}};
  MinkowskiDifference difference(b, 0, a, 0);

  // The difference is a cube of 2 m. The base is a part of its lowest face. The origin is above the base, near its
  // border, or beside it.
  for (const Real left : {leftmost, Real(-0.001), Real(0.1)}) {
    SCOPED_TRACE(testing::Message() << "base from x = " << left);
    const std::array<Vec3, 4> base = {
        Vec3(left, Real(-0.5), lowest), Vec3(left + 1, Real(-0.5), lowest),
        Vec3(left + 1, Real(0.5), lowest), Vec3(left, Real(0.5), lowest)};
    EXPECT_TRUE(difference.limits_separation(Real(0.99) * leftmost, base, Vec3::UnitZ()));
    EXPECT_FALSE(difference.limits_separation(Real(1.01) * leftmost, base, Vec3::UnitZ()));
  }
}

TEST(MinkowskiDifference, OfCubesApartHasAPointAtTheirDistance) {
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  const Real distance = Real(0.01);
  const PosedShape a{cube.get(), {}};
  const PosedShape b{cube.get(), {{0, 0, 1 + distance}, Quat::Identity()}};
  MinkowskiDifference difference(b, 0, a, 0);
  std::array<Vec3, 4> base = {Vec3(-1, -1, distance), Vec3(1, -1, distance), Vec3(1, 1, distance),
                              Vec3(-1, 1, distance)};
  EXPECT_TRUE(difference.limits_separation(distance, base, Vec3::UnitZ()));
  // If the origin is not below the base, its points are farther away than that.
  for (Vec3& point : base) point.x() += Real(1.5);
  EXPECT_FALSE(difference.limits_separation(distance, base, Vec3::UnitZ()));
}

TEST(MinkowskiDifference, LimitsNoSeparationBelowTheTrueOne) {
  Random random(41);
  int proved = 0;
  for (int i = 0; i < 300; ++i) {
    const OverlappingHulls hulls(random);
    const double depth = hulls.depth();
    constexpr double rounding = 1e-6;  // of differences of about a metre, in float
    for (int trial = 0; trial < 20; ++trial) {
      FaceQuery query;
      query.face = random.integer(0, hulls.a.mesh().face_count() - 1);
      const Vec3 inward = -hulls.a.plane(query.face).normal;
      query.vertex = support(hulls.b, inward).vertex;
      const Real radius = random.real(0, 2) * static_cast<Real>(depth);
      const Plane plane = hulls.a.plane(query.face);
      const bool base_is_within = plane.distance(hulls.b.vertex(query.vertex)) <= -radius;
      if (!base_is_within || !proves(hulls.a, hulls.b, query, radius)) continue;
      ++proved;
      EXPECT_LE(double{radius}, depth + rounding) << "seed " << random.seed() << ", pair " << i;
    }
  }
  EXPECT_GT(proved, 100) << "too few proofs to test";
}

TEST(MinkowskiDifference, ProvesTheBestFaceOfMostOverlappingHulls) {
  Random random(42);
  int faces = 0;
  int proved = 0;
  for (int i = 0; i < 400; ++i) {
    const OverlappingHulls hulls(random);
    const SeparatingAxis axis = find_separating_axis(hulls.a, hulls.b, {}, HUGE_VALF);
    if (axis.feature != AxisFeature::FaceA) continue;
    ++faces;
    if (proves(hulls.a, hulls.b, axis.face_a, Real(-0.99) * axis.separation)) ++proved;
  }
  EXPECT_GT(faces, 50) << "too few pairs to test";
  EXPECT_GE(proved, faces * 8 / 10) << "seed " << random.seed();
}

}  // namespace
}  // namespace cs550
