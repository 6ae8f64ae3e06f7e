// Every engine simulates the same scene.

#include "benchmarks/engines/engine.hpp"

#include <gtest/gtest.h>

#include <set>

#include "benchmarks/runs/runs.hpp"

namespace cs550::bench {
namespace {

std::vector<Engine> all_engines() {
  std::vector<Engine> engines = own_engines();
  for (const Engine& engine : peer_engines()) engines.push_back(engine);
  return engines;
}

/// One body in free fall for a second, on no floor.
TEST(Engines, DropABodyAsFarAsGravityDoes) {
  const BenchScene scene = lone_cubes(2);
  constexpr int steps = 60;
  // Semi-implicit Euler, in steps or finer: between these two.
  const double closed_form = -9.81 / 2;
  const double coarsest = closed_form * (1 + 1.0 / steps);
  for (const Engine& engine : all_engines()) {
    const std::unique_ptr<Simulation> simulation = engine.start(scene, engine.usual_effort);
    for (int i = 0; i < steps; ++i) simulation->step(step_length);
    const BodyMotion motion = simulation->motion(3);
    EXPECT_NEAR(motion.velocity.z(), -9.81, 1e-3) << engine.name;
    EXPECT_GE(motion.position.z(), coarsest - 1e-3) << engine.name;
    EXPECT_LE(motion.position.z(), closed_form + 1e-3) << engine.name;
    EXPECT_NEAR(motion.position.x(), static_cast<double>(scene.bodies[3].pose.position.x()), 1e-6)
        << engine.name;
  }
}

/// Masses, inertias, friction and shapes have arrived if piles behave.
TEST(Engines, HoldCubesAndHullsForASecond) {
  for (const BenchScene& scene : {columns_of_cubes(2), pile_of_hulls(2, 2, 16)}) {
    for (const Engine& engine : all_engines()) {
      const SceneRun run = run_scene(scene, engine, engine.usual_effort, 60);
      EXPECT_EQ(run.quality.lost_bodies, 0) << engine.name;
      EXPECT_LT(run.quality.deepest, 0.3) << engine.name;
      EXPECT_GT(run.quality.kinetic_energy, 0) << engine.name;
      EXPECT_GT(run.seconds, 0) << engine.name;
    }
  }
}

TEST(Scenes, HaveTheirBodies) {
  const int expected[] = {210, 250, 512, 256, 256, 1000, 1000};
  ASSERT_EQ(compared_scenes().size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    const NamedScene& named = compared_scenes()[i];
    const BenchScene scene = named.make();
    int dynamic = 0;
    for (const BodyDef& body : scene.bodies) {
      if (body.kind != BodyKind::Dynamic) continue;
      ++dynamic;
      const Mat3& inertia = body.shape->unit_inertia;
      const Mat3 off_diagonal = inertia - Mat3(inertia.diagonal().asDiagonal());
      EXPECT_LT(off_diagonal.norm(), 1e-4 * inertia.norm()) << named.name;
    }
    EXPECT_EQ(dynamic, expected[i]) << named.name;
  }
}

TEST(Scenes, AreRecognisedAsBoxes) {
  EXPECT_TRUE(has_only_boxes(lone_cubes(1)));
  EXPECT_FALSE(has_only_boxes(pile_of_hulls(1, 1, 8)));
}

TEST(Scenes, ShareShapesInTurn) {
  const BenchScene own = pile_of_hulls(3, 1, 8);
  const BenchScene shared = pile_of_shared_hulls(3, 1, 8, 4);
  std::set<ShapePtr> shapes;
  ASSERT_EQ(shared.bodies.size(), own.bodies.size());
  for (std::size_t i = 0; i < own.bodies.size(); ++i) {
    EXPECT_TRUE(shared.bodies[i].pose.position == own.bodies[i].pose.position);
    if (shared.bodies[i].kind == BodyKind::Dynamic) shapes.insert(shared.bodies[i].shape);
  }
  EXPECT_EQ(shapes.size(), 4U);
}

TEST(Memory, IsCounted) {
  const Memory memory = measure_memory();
  EXPECT_GT(memory.bytes_per_body, sizeof(RigidBody));
  EXPECT_GT(memory.bytes_per_contact, sizeof(Contact));
  EXPECT_LT(memory.bytes_per_body, 100 * sizeof(RigidBody));
  EXPECT_EQ(memory.allocations_per_step, 0);
}

}  // namespace
}  // namespace cs550::bench
