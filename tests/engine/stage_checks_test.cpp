// Every promise that a stage can break is reported once, and what it broke is undone.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "engine/pairs_of_contacts.hpp"
#include "engine/test_bodies.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr Real broken_number = std::numeric_limits<Real>::quiet_NaN();
constexpr Real endless = std::numeric_limits<Real>::infinity();

/// Two cubes and a prism in a row at step 7. The second pair has a manifold of one point, and an axis whose queries
/// name the last element of each kind. A cube has 6 faces, 8 vertices and 24 half-edges, the prism 8, 12 and 36.
WorldState row_of_bodies() {
  WorldState world;
  world.step_count = 7;
  const ShapePtr prism = shape_of(prism_soup(6, Real(0.5), 1));
  for (const ShapePtr& shape : {unit_box(), unit_box(), prism}) {
    const auto x = static_cast<Real>(world.bodies.size());
    world.definitions.push_back(body_at(shape, {x, 0, 0}));
    world.bodies.emplace_back().pose = world.definitions.back().pose;
    world.slots.emplace_back().alive = true;
  }
  Contact near;
  near.body_a = 0;
  near.body_b = 1;
  Contact touching = near;
  touching.body_a = 1;
  touching.body_b = 2;
  touching.manifold.normal = Vec3::UnitX();
  touching.manifold.tangent = Vec3::UnitY();
  touching.manifold.reference = AxisFeature::FaceA;
  ContactPoint point;
  point.anchor_a = {Real(0.5), 0, 0};
  point.anchor_b = {Real(-0.5), 0, 0};
  touching.manifold.points.push_back(point);
  world.pairs = pairs_of(std::vector{near, touching});
  SeparatingAxis& axis = world.pairs.axes[1];
  axis.feature = AxisFeature::FaceA;
  axis.axis = Vec3::UnitX();
  axis.face_a = {5, 11, 0};
  axis.face_b = {7, 7, 0};
  axis.edges = {23, 35, Vec3::UnitX(), 0};
  return world;
}

void expect_one_problem(const WorldState& world, Stage stage, int lab, Index body,
                        const std::string& promise) {
  ASSERT_EQ(world.problems.size(), 1U);
  const StageProblem& problem = world.problems[0];
  EXPECT_EQ(problem.stage, stage);
  EXPECT_EQ(problem.lab, lab);
  EXPECT_EQ(problem.body, body);
  EXPECT_EQ(problem.step, 7);
  EXPECT_EQ(problem.message, std::string("stage ") + to_string(stage) + " (lab " +
                                 std::to_string(lab) + "), body " + std::to_string(body) +
                                 ", step 7: " + promise);
}

TEST(StageChecks, FindNothingWrongWithSoundBodies) {
  WorldState world = row_of_bodies();
  check_bodies(world, Stage::Solve, 1);
  check_axes(world);
  check_manifolds(world);
  EXPECT_TRUE(world.problems.empty()) << world.problems[0].message;
  EXPECT_EQ(world.pairs.axes[1].feature, AxisFeature::FaceA);
  EXPECT_EQ(world.pairs.summaries[1].points, 1);
}

TEST(StageChecks, ReportAndClearABrokenManifold) {
  const struct {
    void (*spoil)(Manifold&);
    const char* promise;
  } cases[] = {
      {[](Manifold& m) { m.normal *= Real(1.1); }, "the normal is not a unit vector"},
      {[](Manifold& m) { m.normal.y() = broken_number; }, "the normal is not a unit vector"},
      {[](Manifold& m) {
         m.tangent = {Real(0.6), Real(0.8), 0};
       },
       "the tangent is not a unit vector perpendicular to the normal"},
      {[](Manifold& m) { m.tangent *= Real(0.9); },
       "the tangent is not a unit vector perpendicular to the normal"},
      {[](Manifold& m) { m.points[0].anchor_a.z() = broken_number; },
       "a contact point is not finite"},
      {[](Manifold& m) { m.points[0].anchor_b.x() = endless; }, "a contact point is not finite"},
      {[](Manifold& m) { m.points[0].separation = -endless; }, "a contact point is not finite"},
  };
  for (const auto& [spoil, promise] : cases) {
    WorldState world = row_of_bodies();
    spoil(world.pairs.contacts[1].manifold);
    check_manifolds(world);
    expect_one_problem(world, Stage::Manifolds, 5, 1, promise);
    EXPECT_TRUE(world.pairs.contacts[1].manifold.points.empty());
    EXPECT_EQ(world.pairs.summaries[1].points, 0) << "later stages see no point";
  }
}

TEST(StageChecks, IgnoreTheNormalOfAnEmptyManifold) {
  WorldState world = row_of_bodies();
  world.pairs.contacts[0].manifold.normal.x() = broken_number;
  check_manifolds(world);
  EXPECT_TRUE(world.problems.empty());
}

TEST(StageChecks, ReportAndForgetABrokenAxis) {
  constexpr const char* no_such_face = "a face query names a face or vertex that does not exist";
  constexpr const char* no_such_edge = "the edge query names an edge that does not exist";
  const struct {
    void (*spoil)(SeparatingAxis&);
    const char* promise;
  } cases[] = {
      {[](SeparatingAxis& axis) { axis.separation = broken_number; },
       "the separation is not finite"},
      {[](SeparatingAxis& axis) { axis.separation = endless; }, "the separation is not finite"},
      {[](SeparatingAxis& axis) { axis.axis *= Real(1.1); }, "the axis is not a unit vector"},
      {[](SeparatingAxis& axis) { axis.face_a.face = 6; }, no_such_face},
      {[](SeparatingAxis& axis) { axis.face_a.vertex = 12; }, no_such_face},
      {[](SeparatingAxis& axis) { axis.face_a.vertex = no_index; }, no_such_face},
      {[](SeparatingAxis& axis) { axis.face_b.face = 8; }, no_such_face},
      {[](SeparatingAxis& axis) { axis.face_b.vertex = 8; }, no_such_face},
      {[](SeparatingAxis& axis) { axis.edges.edge_a = 24; }, no_such_edge},
      {[](SeparatingAxis& axis) { axis.edges.edge_b = 36; }, no_such_edge},
      {[](SeparatingAxis& axis) { axis.edges.edge_b = no_index; }, no_such_edge},
  };
  for (const auto& [spoil, promise] : cases) {
    WorldState world = row_of_bodies();
    spoil(world.pairs.axes[1]);
    check_axes(world);
    expect_one_problem(world, Stage::Collide, 4, 1, promise);
    EXPECT_EQ(world.pairs.axes[1].feature, AxisFeature::None);
    EXPECT_FALSE(world.pairs.axes[1].face_a || world.pairs.axes[1].face_b ||
                 world.pairs.axes[1].edges)
        << "the next step must not begin with it";
  }
}

TEST(StageChecks, ReportABrokenBodyOnceInAStep) {
  const struct {
    void (*spoil)(RigidBody&);
    const char* promise;
  } cases[] = {
      {[](RigidBody& body) { body.pose.orientation.coeffs() *= Real(1.01); },
       "the orientation is not a unit quaternion"},
      {[](RigidBody& body) { body.pose.position.y() = endless; },
       "position or linear momentum is not finite"},
      {[](RigidBody& body) { body.linear_momentum.z() = broken_number; },
       "position or linear momentum is not finite"},
      {[](RigidBody& body) { body.pose.orientation.w() = broken_number; },
       "orientation or angular momentum is not finite"},
      {[](RigidBody& body) { body.angular_momentum.x() = endless; },
       "orientation or angular momentum is not finite"},
      {[](RigidBody& body) { body.linear_velocity.x() = broken_number; },
       "a velocity is not finite"},
      {[](RigidBody& body) { body.angular_velocity.x() = broken_number; },
       "a velocity is not finite"},
  };
  for (const auto& [spoil, promise] : cases) {
    WorldState world = row_of_bodies();
    world.bodies_before = world.bodies;
    spoil(world.bodies[2]);
    check_bodies(world, Stage::Integrate, 1);
    check_bodies(world, Stage::Solve, 7);
    expect_one_problem(world, Stage::Integrate, 1, 2, promise);
    restore_broken_bodies(world);
    EXPECT_EQ(world.bodies[2].pose.position, world.bodies_before[2].pose.position);
    EXPECT_EQ(world.bodies[2].pose.orientation.coeffs(), Quat::Identity().coeffs());
    world.problems.clear();
    check_bodies(world, Stage::Integrate, 1);
    EXPECT_TRUE(world.problems.empty()) << "after: " << promise;
  }
}

}  // namespace
}  // namespace cs550
