// The evaluator against closed forms.

#include "benchmarks/quality/quality.hpp"

#include <gtest/gtest.h>

#include "benchmarks/quality/hull_overlap.hpp"
#include "cs550/primitives.hpp"
#include "helpers/exact_separation.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using test::best_separations;
using test::ExactBody;
using test::Random;

ShapePtr box(const Vec3& half_extents) {
  const TriangleSoup soup = box_soup(half_extents);
  return make_shape(soup.vertices, soup.triangles).shape;
}

BodyMotion at(const Vector3d& position,
              const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity()) {
  BodyMotion motion;
  motion.position = position;
  motion.orientation = orientation;
  return motion;
}

double depth(const ConvexShape& a, const BodyMotion& at_a, const ConvexShape& b,
             const BodyMotion& at_b) {
  return penetration_depth(PlacedHull(a, at_a), PlacedHull(b, at_b));
}

TEST(PenetrationDepth, OfBoxesSideBySideIsTheirOverlap) {
  const ShapePtr cube = box(Vec3::Constant(0.5));
  for (const double overlap : {0.5, 1e-2, 1e-6, 1e-12}) {
    EXPECT_NEAR(depth(*cube, at({0, 0, 0}), *cube, at({0.3, 1 - overlap, 0.2})), overlap, 1e-14);
  }
}

TEST(PenetrationDepth, OfBoxesApartIsZero) {
  const ShapePtr cube = box(Vec3::Constant(0.5));
  EXPECT_EQ(depth(*cube, at({0, 0, 0}), *cube, at({0, 1 + 1e-9, 0})), 0);
  // Only a cross product of edges separates these: their bounds overlap, and so do they along every
  // face normal.
  const Eigen::Quaterniond on_edge_a(AngleAxisd(M_PI / 4, Vector3d::UnitX()));
  const Eigen::Quaterniond on_edge_b(AngleAxisd(M_PI / 4, Vector3d::UnitY()));
  EXPECT_EQ(
      depth(*cube, at({0, 0, 0}, on_edge_a), *cube, at({0, 0, std::sqrt(2) + 1e-9}, on_edge_b)), 0);
}

TEST(PenetrationDepth, OfCrossedEdgesIsTheirDistance) {
  const ShapePtr cube = box(Vec3::Constant(0.5));
  const Eigen::Quaterniond on_edge_a(AngleAxisd(M_PI / 4, Vector3d::UnitX()));
  const Eigen::Quaterniond on_edge_b(AngleAxisd(M_PI / 4, Vector3d::UnitY()));
  EXPECT_NEAR(
      depth(*cube, at({0, 0, 0}, on_edge_a), *cube, at({0, 0, std::sqrt(2) - 0.01}, on_edge_b)),
      0.01, 1e-7);
}

TEST(PenetrationDepth, OfACornerInAFaceIsItsDistance) {
  const ShapePtr floor = box({5, 5, 1});
  const ShapePtr cube = box(Vec3::Constant(0.5));
  // The diagonal of the cube points down.
  const auto on_corner = Eigen::Quaterniond::FromTwoVectors(Vector3d(1, 1, 1), Vector3d(0, 0, -1));
  const double half_diagonal = std::sqrt(3) / 2;
  EXPECT_NEAR(depth(*floor, at({0, 0, -1}), *cube, at({0.2, 0.1, half_diagonal - 0.03}, on_corner)),
              0.03, 1e-7);
}

TEST(PenetrationDepth, OfRandomHullsMatchesBruteForce) {
  Random random(50);
  int overlapping = 0;
  for (int i = 0; i < 60; ++i) {
    const TriangleSoup soup = convex_hull(random_sphere_points(12, 100 + i)).soup;
    const ShapePtr hull = make_shape(soup.vertices, soup.triangles).shape;
    const PosedShape a{hull.get(), {Vec3::Zero(), random.orientation()}};
    const PosedShape b{hull.get(),
                       {random.real(1, 2) * random.unit_vector(), random.orientation()}};
    const auto motion_of = [](const PosedShape& body) {
      return at(body.pose.position.cast<double>(), body.pose.orientation.cast<double>());
    };
    const double separation =
        best_separations(ExactBody(a, Vec3::Zero()), ExactBody(b, Vec3::Zero())).largest();
    EXPECT_NEAR(depth(*hull, motion_of(a), *hull, motion_of(b)), std::max(0.0, -separation), 1e-6);
    overlapping += separation < 0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, 15);
  EXPECT_LT(overlapping, 45);
}

TEST(PenetrationDepth, DoesNotDependOnTheOrderOrThePlace) {
  const TriangleSoup soup = convex_hull(random_sphere_points(30, 5)).soup;
  const ShapePtr hull = make_shape(soup.vertices, soup.triangles).shape;
  const BodyMotion a = at({0, 0, 0}, Eigen::Quaterniond(0.4, -0.2, 0.7, 0.1).normalized());
  const BodyMotion b = at({1.1, 0.9, 0.8}, Eigen::Quaterniond(0.1, 0.9, 0.3, -0.2).normalized());
  const double expected = depth(*hull, a, *hull, b);
  ASSERT_GT(expected, 0.01);
  EXPECT_NEAR(depth(*hull, b, *hull, a), expected, 1e-13);
  const Vector3d far(1000, -2000, 500);
  const BodyMotion far_a = at(a.position + far, a.orientation);
  EXPECT_NEAR(depth(*hull, far_a, *hull, at(b.position + far, b.orientation)), expected, 1e-9);
}

/// A floor and two cubes of 1000 kg.
BenchScene two_cubes() {
  BenchScene scene;
  scene.half_width = 10;
  scene.stays_upright = true;
  BodyDef floor;
  floor.kind = BodyKind::Static;
  floor.shape = box({10, 10, 1});
  floor.pose.position = {0, 0, -1};
  BodyDef cube;
  cube.shape = box(Vec3::Constant(0.5));
  cube.pose.position = {0, 0, Real(0.5)};
  scene.bodies = {floor, cube, cube};
  return scene;
}

TEST(Quality, OfAKnownStateIsItsClosedForm) {
  const BenchScene scene = two_cubes();
  // The first cube is 30 mm in the floor, the second 10 mm in the first, 0.4 m beside its place.
  std::vector<BodyMotion> motions = {at({0, 0, -1}), at({0, 0, 0.47}), at({0.4, 0, 1.46})};
  motions[2].velocity = {0, 3, 0};
  motions[2].angular_velocity = {0, 0, 2};
  const Quality quality = evaluate(scene, motions);
  EXPECT_NEAR(quality.deepest, 0.03, 1e-9);
  EXPECT_EQ(quality.deep_pairs, 1) << "only the first is deeper than 20 mm";
  // ½·1000·3² + ½·(1000/6)·2²
  EXPECT_NEAR(quality.kinetic_energy, 4500 + 1000.0 / 3, 1e-2);
  EXPECT_NEAR(quality.drift.value(), 0.4, 1e-9);
  EXPECT_EQ(quality.lost_bodies, 0);
}

TEST(Quality, AtRestIsPerfect) {
  const BenchScene scene = two_cubes();
  const std::vector<BodyMotion> motions = {at({0, 0, -1}), at({0, 0, 0.5}), at({0, 0, 1.5})};
  const Quality quality = evaluate(scene, motions);
  EXPECT_LT(quality.deepest, 1e-12);
  EXPECT_EQ(quality.deep_pairs + quality.lost_bodies, 0);
  EXPECT_EQ(quality.kinetic_energy, 0);
  EXPECT_EQ(quality.drift.value(), 0);
}

TEST(Quality, HasNoDriftWhereBodiesMaySpread) {
  BenchScene scene = two_cubes();
  scene.stays_upright = false;
  EXPECT_FALSE(evaluate(scene, std::vector<BodyMotion>(3)).drift.has_value());
}

TEST(Quality, CountsBodiesThatAreLost) {
  const BenchScene scene = two_cubes();
  const std::vector<BodyMotion> motions = {at({0, 0, -1}), at({0, 0, NAN}), at({11, 0, 0.5})};
  EXPECT_EQ(evaluate(scene, motions).lost_bodies, 2);
  const std::vector<BodyMotion> below = {at({0, 0, -1}), at({0, 0, -0.6}), at({0, 0, 0.5})};
  EXPECT_EQ(evaluate(scene, below).lost_bodies, 1);
}

}  // namespace
}  // namespace cs550::bench
