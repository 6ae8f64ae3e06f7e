// World::axes() is in the order of World::contacts(), also after bodies come and go.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// Two cubes of 1 m that overlap along a known axis.
struct CrossedCubes {
  BodyDef a;
  BodyDef b;
  AxisFeature feature;
  Vec3 axis;
  Real depth;
};

BodyDef cube_at(const Vec3& position, const Quat& orientation) {
  BodyDef def = body_at(unit_box(), position);
  def.pose.orientation = orientation;
  return def;
}

std::vector<CrossedCubes> three_kinds_of_pairs() {
  const Quat upright = Quat::Identity();
  // Its diagonal is parallel to the x axis.
  const Quat on_corner = Quat::FromTwoVectors(Vec3::Ones(), Vec3::UnitX());
  const Quat about_x(Eigen::AngleAxis<Real>(pi / 4, Vec3::UnitX()));
  const Quat about_y(Eigen::AngleAxis<Real>(pi / 4, Vec3::UnitY()));
  const Real from_corner = std::sqrt(Real(3)) / 2;
  const Real from_edge = std::sqrt(Real(2)) / 2;
  const Vec3 corner_on_face = (from_corner + Real(0.5)) * Vec3::UnitX();
  const Vec3 edge_on_edge = 2 * from_edge * Vec3::UnitZ();
  const auto crossed = [](const Vec3& a, const Quat& turn_a, const Vec3& apart, const Quat& turn_b,
                          AxisFeature feature, Real depth) {
    const Vec3 axis = apart.normalized();
    return CrossedCubes{cube_at(a, turn_a), cube_at(a + apart - depth * axis, turn_b), feature,
                        axis, depth};
  };
  return {crossed({0, 0, 0}, upright, corner_on_face, on_corner, AxisFeature::FaceA, Real(0.01)),
          crossed({0, 9, 0}, on_corner, -corner_on_face, upright, AxisFeature::FaceB, Real(0.02)),
          crossed({9, 0, 0}, about_x, edge_on_edge, about_y, AxisFeature::Edges, Real(0.03))};
}

/// Checks the pairs of the world, in the order of their first bodies.
void expect_axes(const World& world, const std::vector<CrossedCubes>& pairs) {
  ASSERT_EQ(world.contacts().size(), pairs.size());
  ASSERT_EQ(world.axes().size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    SCOPED_TRACE(i);
    const Vec3& place = world.definition(world.id_at(world.contacts()[i].body_a)).pose.position;
    ASSERT_EQ(place, pairs[i].a.pose.position);
    const SeparatingAxis& axis = world.axes()[i];
    EXPECT_EQ(axis.feature, pairs[i].feature);
    // Rounding at 10 m from the origin.
    EXPECT_LE((axis.axis - pairs[i].axis).norm(), 1e-5);
    EXPECT_NEAR(axis.separation, -pairs[i].depth, 1e-5);
  }
}

TEST(Axes, AreInTheOrderOfTheContacts) {
  const std::vector<CrossedCubes> pairs = three_kinds_of_pairs();
  World world;
  world.settings().gravity.setZero();
  world.settings().max_push_speed = 0;  // so that the bodies stay in each other
  std::vector<BodyId> first;
  for (const CrossedCubes& pair : pairs) first.push_back(world.add_body(pair.a));
  for (const CrossedCubes& pair : pairs) world.add_body(pair.b);
  world.step(step_length);
  expect_axes(world, pairs);
  world.remove_body(first[0]);
  expect_axes(world, {pairs[1], pairs[2]});
  world.step(step_length);
  EXPECT_EQ(world.stats().kept, 2) << "these axes are those of the first step";
  expect_axes(world, {pairs[1], pairs[2]});
  world.add_body(pairs[0].a);  // at the index of the one that was removed
  world.step(step_length);
  EXPECT_EQ(world.stats().kept, 2);
  expect_axes(world, pairs);
}

}  // namespace
}  // namespace cs550
