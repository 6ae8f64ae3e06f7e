// Functions of math.hpp: angles with the same bits in every C library, directions, boxes.

#include "cs550/math.hpp"

#include <gtest/gtest.h>

#include "helpers/random.hpp"

namespace cs550 {
namespace {

TEST(SineAndCosine, AreTheNearestNumbers) {
  // A long double has 40 bits more than a float: rounding twice cannot matter for these angles.
  for (int i = -20'000; i <= 20'000; ++i) {
    const Real angle = static_cast<Real>(i) * Real(3.7e-4);  // up to 7.4 rad
    EXPECT_EQ(sine(angle), static_cast<Real>(std::sin(static_cast<long double>(angle))));
    EXPECT_EQ(cosine(angle), static_cast<Real>(std::cos(static_cast<long double>(angle))));
  }
}

/// Errors are a few roundings of numbers of at most 1, each of 6e-8.
void expect_perpendicular(const Vec3& n) {
  const Eigen::Vector3d u = any_perpendicular(n).cast<double>();
  EXPECT_LE(std::abs(u.dot(n.cast<double>())), 1e-6) << n.transpose();
  EXPECT_LE(std::abs(u.norm() - 1), 1e-6) << n.transpose();
}

TEST(AnyPerpendicular, IsAUnitVectorForEveryNormal) {
  for (int axis = 0; axis < 3; ++axis) {
    expect_perpendicular(Vec3::Unit(axis));
    expect_perpendicular(-Vec3::Unit(axis));
  }
  test::Random random(41);
  for (int i = 0; i < 10'000; ++i) expect_perpendicular(random.unit_vector());
}

/// The box between two corners that differ from those of the unit cube along one axis.
Bounds stretched(int axis, Real lower, Real upper) {
  Bounds box{Vec3::Zero(), Vec3::Ones()};
  box.lower[axis] = lower;
  box.upper[axis] = upper;
  return box;
}

TEST(Bounds, ThatShareOneFaceOverlap) {
  const Bounds cube{Vec3::Zero(), Vec3::Ones()};
  const Real beyond = std::nextafter(Real(1), Real(2));
  const Real before = std::nextafter(Real(0), Real(-1));
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    EXPECT_TRUE(cube.overlaps(stretched(axis, 1, 2)));
    EXPECT_TRUE(cube.overlaps(stretched(axis, -1, 0)));
    EXPECT_FALSE(cube.overlaps(stretched(axis, beyond, 2)));
    EXPECT_FALSE(cube.overlaps(stretched(axis, -1, before)));
  }
  EXPECT_TRUE(cube.overlaps({Vec3::Ones(), Vec3::Constant(2)})) << "one corner in common";
  EXPECT_FALSE(cube.overlaps({})) << "an empty box has no point";
}

TEST(Bounds, ContainThoseThatTouchThemFromInside) {
  const Bounds cube{Vec3::Zero(), Vec3::Ones()};
  EXPECT_TRUE(cube.contains(cube));
  const Real beyond = std::nextafter(Real(1), Real(2));
  const Real before = std::nextafter(Real(0), Real(-1));
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    EXPECT_TRUE(cube.contains(stretched(axis, 0, Real(0.5))));
    EXPECT_TRUE(cube.contains(stretched(axis, Real(0.5), 1)));
    EXPECT_FALSE(cube.contains(stretched(axis, Real(0.5), beyond)));
    EXPECT_FALSE(cube.contains(stretched(axis, before, Real(0.5))));
  }
}

}  // namespace
}  // namespace cs550
