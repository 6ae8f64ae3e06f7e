// Ray and box queries against brute force in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cs550/world.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

World scattered_hulls(Random& random, int count) {
  WorldSettings weightless;
  weightless.gravity.setZero();
  World world(weightless);
  for (int i = 0; i < count; ++i) {
    const int vertices = random.integer(6, 30);
    const Real radius = random.real(Real(0.3), Real(1.5));
    const ShapePtr shape = random_hull(random, vertices, Vec3::Constant(radius));
    BodyDef def = body_at(shape, random.point_in_box(Vec3::Constant(10)), BodyKind::Kinematic);
    def.pose.orientation = random.orientation();
    def.linear_velocity = random.unit_vector();
    world.add_body(def);
  }
  return world;
}

/// The distance at which a ray enters a convex body from outside, by clipping it with all face
/// planes (Cyrus & Beck 1978).
std::optional<double> entry_distance(const PosedShape& body, const Eigen::Vector3d& origin,
                                     const Eigen::Vector3d& direction) {
  const Eigen::Quaterniond turn(body.pose.orientation.cast<double>());
  const Eigen::Vector3d position = body.pose.position.cast<double>();
  double entry = -HUGE_VAL;
  double exit = HUGE_VAL;
  for (const Face& face : body.mesh().faces) {
    const Eigen::Vector3d normal = turn * face.plane.normal.cast<double>();
    const double height = normal.dot(origin - position) - static_cast<double>(face.plane.offset);
    const double climb = normal.dot(direction);
    if (climb < 0) entry = std::max(entry, -height / climb);
    if (climb > 0) exit = std::min(exit, -height / climb);
    if (climb == 0 && height > 0) return std::nullopt;
  }
  if (entry < 0 || entry > exit) return std::nullopt;
  return entry;
}

TEST(WorldQuery, RayCastFindsTheNearestFace) {
  Random random(21);
  World world = scattered_hulls(random, 60);
  run(world, 30);  // bodies have moved since they were inserted into the tree
  int hits = 0;
  for (int ray = 0; ray < 3000; ++ray) {
    SCOPED_TRACE(testing::Message() << "seed 21, ray " << ray);
    const Vec3 origin = random.point_in_box(Vec3::Constant(14));
    // Towards the bodies, not of unit length.
    const Vec3 direction = random.point_in_box(Vec3::Constant(6)) - origin;
    const Real length = random.real(1, 30);

    const Eigen::Vector3d unit = direction.cast<double>().normalized();
    double nearest = length;
    for (Index i = 0; i < static_cast<Index>(world.bodies().size()); ++i) {
      const auto distance =
          entry_distance(world.posed_shape(world.id_at(i)), origin.cast<double>(), unit);
      if (distance) nearest = std::min(nearest, *distance);
    }
    const auto hit = world.ray_cast(origin, direction, length);
    // Rounding decides about rays that graze a body or end at its surface.
    if (!hit) {
      ASSERT_GT(nearest, length - Real(1e-4)) << "missed a body at " << nearest << " m";
      continue;
    }
    ++hits;
    ASSERT_NEAR(hit->distance, nearest, 1e-4);
    ASSERT_LT((hit->point - (origin + hit->distance * direction.normalized())).norm(), 1e-4F);
    const Plane face = world.posed_shape(hit->body).plane(hit->face);
    ASSERT_NEAR(face.distance(hit->point), 0, 1e-4);
    ASSERT_LT((face.normal - hit->normal).norm(), 1e-5F);
    ASSERT_LT(hit->normal.dot(direction), 0) << "the face looks away from the ray";
  }
  EXPECT_GT(hits, 500);
}

TEST(WorldQuery, RayFromInsideABodyMeetsTheNextOne) {
  World world;
  const ShapePtr box = box_shape(Vec3::Ones());
  world.add_body(body_at(box, Vec3::Zero(), BodyKind::Static));
  const BodyId next = world.add_body(body_at(box, {5, 0, 0}, BodyKind::Static));
  const auto hit = world.ray_cast(Vec3::Zero(), Vec3::UnitX(), 10);
  ASSERT_TRUE(hit);
  EXPECT_TRUE(hit->body == next);
  EXPECT_NEAR(hit->distance, 4, 1e-6);
  EXPECT_FALSE(world.ray_cast(Vec3::Zero(), Vec3::UnitX(), Real(3.9)));
  EXPECT_FALSE(world.ray_cast(Vec3::Zero(), -Vec3::UnitX(), 10));
}

TEST(WorldQuery, RemovedBodiesAreNotFound) {
  World world;
  const BodyId id = world.add_body(body_at(box_shape(Vec3::Ones()), Vec3::Zero()));
  const Bounds everything{Vec3::Constant(-9), Vec3::Constant(9)};
  EXPECT_EQ(world.query(everything).size(), 1U);
  world.remove_body(id);
  EXPECT_TRUE(world.query(everything).empty());
  EXPECT_FALSE(world.ray_cast({-5, 0, 0}, Vec3::UnitX(), 10));
}

TEST(WorldQuery, DirectionOfARayHasAnyLengthButZero) {
  World world;
  world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {5, 0, 0}));
  for (const Real length : {Real(1e-30), Real(1), Real(1e30)}) {
    const auto hit = world.ray_cast({0, 0, 0}, {length, 0, 0}, 10);
    ASSERT_TRUE(hit) << "length " << length;
    EXPECT_NEAR(hit->distance, 4.5, 1e-6);
  }
  world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {5, 5, 5}));
  for (const Real length : {std::numeric_limits<Real>::denorm_min(), Real(1), Real(3e38)}) {
    const auto hit = world.ray_cast({0, 0, 0}, Vec3::Constant(length), 10);
    ASSERT_TRUE(hit) << "length " << length;
    EXPECT_NEAR(hit->distance, 4.5 * std::sqrt(3.0), 1e-5);
  }
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_THROW(world.ray_cast({0, 0, 0}, {0, 0, 0}, 10), std::invalid_argument);
  EXPECT_THROW(world.ray_cast({0, 0, 0}, {nan, 0, 0}, 10), std::invalid_argument);
  EXPECT_THROW(world.ray_cast({nan, 0, 0}, {1, 0, 0}, 10), std::invalid_argument);
  EXPECT_THROW(world.ray_cast({0, 0, 0}, {1, 0, 0}, -1), std::invalid_argument);
  EXPECT_THROW(world.ray_cast({0, 0, 0}, {1, 0, 0}, nan), std::invalid_argument);
}

TEST(WorldQuery, RefusesABoxWhoseCornersAreExchanged) {
  World world;
  world.add_body(body_at(box_shape(Vec3::Ones()), Vec3::Zero()));
  const Vec3 corner = Vec3::Constant(Real(0.5));
  const Vec3 infinite = Vec3::Constant(std::numeric_limits<Real>::infinity());
  EXPECT_EQ(world.query({-corner, corner}).size(), 1U);
  EXPECT_EQ(world.query({corner, corner}).size(), 1U) << "a point";
  EXPECT_EQ(world.query({-infinite, infinite}).size(), 1U);
  EXPECT_TRUE(world.query({}).empty());
  EXPECT_THROW(world.query({corner, -corner}), std::invalid_argument);
  for (int axis = 0; axis < 3; ++axis) {
    Bounds box{-corner, corner};
    std::swap(box.lower[axis], box.upper[axis]);
    EXPECT_THROW(world.query(box), std::invalid_argument) << "axis " << axis;
    box.lower[axis] = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_THROW(world.query(box), std::invalid_argument) << "NaN, axis " << axis;
  }
}

TEST(WorldQuery, BoxFindsTheBodiesWhoseBoundsItMeets) {
  Random random(22);
  World world = scattered_hulls(random, 80);
  run(world, 30);
  std::size_t found = 0;
  for (int query = 0; query < 500; ++query) {
    const Vec3 center = random.point_in_box(Vec3::Constant(10));
    const Vec3 half = random.point_in_box(Vec3::Constant(4)).cwiseAbs();
    const Bounds region{center - half, center + half};
    std::vector<Index> answer;
    for (const BodyId id : world.query(region)) answer.push_back(id.index);
    ASSERT_TRUE(std::is_sorted(answer.begin(), answer.end()));
    for (Index i = 0; i < static_cast<Index>(world.bodies().size()); ++i) {
      const PosedShape body = world.posed_shape(world.id_at(i));
      const bool answered = std::binary_search(answer.begin(), answer.end(), i);
      // Bounds contain all vertices and are not larger than those of the bounding sphere.
      Bounds least;
      for (Index v = 0; v < body.mesh().vertex_count(); ++v) least.include(body.vertex(v));
      const Vec3 reach = Vec3::Constant(body.shape->radius * Real(1.0001));
      const Bounds most{body.pose.position - reach, body.pose.position + reach};
      ASSERT_TRUE(answered || !least.overlaps(region)) << "seed 22, query " << query;
      ASSERT_TRUE(!answered || most.overlaps(region)) << "seed 22, query " << query;
    }
    found += answer.size();
  }
  EXPECT_GT(found, 500U);
}

}  // namespace
}  // namespace cs550
