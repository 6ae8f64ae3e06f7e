// The named settings: what the quality `game` promises, on scenes of several seeds and yaws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr int ten_seconds = 600;
constexpr double at_rest = 0.01;  // J

struct Outcome {
  double kinetic_energy = 0;  ///< J
  double drift = 0;           ///< the largest horizontal displacement (m)
  double penetration = 0;     ///< the deepest in the last step (m)
};

Outcome outcome_of(World& world) {
  std::vector<Vec3> start;
  for (const RigidBody& body : world.bodies()) start.push_back(body.pose.position);
  run(world, ten_seconds);
  Outcome outcome;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const RigidBody& body = world.bodies()[i];
    const Vec3 moved = body.pose.position - start[i];
    outcome.kinetic_energy += static_cast<double>(kinetic_energy(body));
    outcome.drift = std::max<double>(outcome.drift, std::hypot(moved.x(), moved.y()));
  }
  outcome.penetration = -static_cast<double>(world.stats().deepest_separation);
  return outcome;
}

World game_world() {
  World world(game_settings());
  world.add_body(floor_body());
  return world;
}

/// A cube of 1 m whose place is turned about the vertical axis, as it is itself.
void add_cube(World& world, const Vec3& position, Real yaw) {
  static const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  const Quat turn = rotation_exp({0, 0, yaw});
  BodyDef def = body_at(cube, turn * position);
  def.pose.orientation = turn;
  world.add_body(def);
}

Real degrees(int angle) { return static_cast<Real>(angle) * pi / 180; }

class GameQualityAtYaw : public ::testing::TestWithParam<int> {};

/// Box3D's pyramid drifts by 9.5 mm and is 3.5 mm deep.
TEST_P(GameQualityAtYaw, PyramidOfTwentyRowsStandsLong) {
  World world = game_world();
  constexpr int rows = 20;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const Real x = static_cast<Real>(i) - static_cast<Real>(rows - 1 - row) / 2;
      add_cube(world, {x, 0, static_cast<Real>(row) + Real(0.5)}, degrees(GetParam()));
    }
  }
  const Outcome outcome = outcome_of(world);
  EXPECT_LE(outcome.kinetic_energy, at_rest);
  EXPECT_LE(outcome.drift, 9.5e-3);
  EXPECT_LE(outcome.penetration, 3.5e-3);
}

TEST_P(GameQualityAtYaw, StacksOfTenStand) {
  World world = game_world();
  for (int x = -2; x <= 2; ++x) {
    for (int z = 0; z < 10; ++z) {
      const Vec3 position(static_cast<Real>(2 * x), 0, static_cast<Real>(z) + Real(0.5));
      add_cube(world, position, degrees(GetParam()));
    }
  }
  const Outcome outcome = outcome_of(world);
  EXPECT_LE(outcome.kinetic_energy, at_rest);
  EXPECT_LE(outcome.drift, 2e-3);
  EXPECT_LE(outcome.penetration, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Yaws, GameQualityAtYaw, ::testing::Values(0, 17, 45));

/// Ten layers of 16 random hulls, dropped into a bin.
World hulls_in_a_bin(std::uint32_t seed) {
  World world = game_world();
  constexpr Real half_width = 3;
  constexpr Real thickness = Real(0.5);
  const ShapePtr wall = box_shape({half_width + 2 * thickness, thickness, 5});
  for (const int angle : {0, 90, 180, 270}) {
    const Quat turn = rotation_exp({0, 0, degrees(angle)});
    BodyDef def = body_at(wall, turn * Vec3(0, half_width + thickness, 5), BodyKind::Static);
    def.pose.orientation = turn;
    world.add_body(def);
  }
  Random random(seed);
  for (int layer = 0; layer < 10; ++layer) {
    for (int place = 0; place < 16; ++place) {
      const int row = place / 4;
      const Vec3 cell(static_cast<Real>(place % 4), static_cast<Real>(row),
                      static_cast<Real>(layer));
      BodyDef def = body_at(random_hull(random, 32, Vec3::Constant(Real(0.5))),
                            Real(1.2) * (cell - Vec3(Real(1.5), Real(1.5), -1)));
      def.pose.orientation = random.orientation();
      world.add_body(def);
    }
  }
  return world;
}

/// The number of bodies that move farther in two seconds than a body at rest may (engine/islands/rest.hpp).
int count_creeping_bodies(World& world) {
  constexpr int two_seconds = 120;
  constexpr Real fastest_at_rest = Real(0.8e-3);  // m/s
  std::vector<Pose> before;
  for (const RigidBody& body : world.bodies()) before.push_back(body.pose);
  run(world, two_seconds);
  int creeping = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3 moved = world.bodies()[i].pose.position - before[i].position;
    if (moved.norm() > 2 * fastest_at_rest) ++creeping;
  }
  return creeping;
}

/// Without rolling resistance single hulls swing on two corners for minutes. With passes back and forth 12
/// of these 640 hulls creep, and two of the piles have more energy left.
TEST(GameQuality, PilesOfHullsComeToRestLong) {
  int creeping = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = hulls_in_a_bin(seed);
    const Outcome outcome = outcome_of(world);
    EXPECT_LE(outcome.kinetic_energy, at_rest);
    EXPECT_LE(outcome.penetration, 10e-3);
    creeping += count_creeping_bodies(world);
  }
  EXPECT_LE(creeping, 4);
}

/// Two cubes on a floor, after a number of steps without them.
World cubes_on_a_floor(PassOrder order, int earlier_steps) {
  WorldSettings settings;
  settings.pass_order = order;
  settings.iterations = 1;
  settings.relax_iterations = 0;
  World world(settings);
  world.add_body(floor_body());
  run(world, earlier_steps);
  for (const Real height : {Real(0.499), Real(1.498)}) add_cube(world, {0, 0, height}, 0);
  run(world, 1);
  return world;
}

/// A single pass leaves the last visited contact without approach, so its direction shows in the poses.
TEST(PassOrder, StepByStepTurnsRoundAfterEveryStep) {
  const auto top_after = [](PassOrder order, int earlier_steps) {
    return cubes_on_a_floor(order, earlier_steps).bodies()[2].pose.position.z();
  };
  const Real forwards = top_after(PassOrder::StepByStep, 0);
  EXPECT_NE(forwards, top_after(PassOrder::StepByStep, 1));
  EXPECT_EQ(forwards, top_after(PassOrder::StepByStep, 2));
  EXPECT_EQ(forwards, top_after(PassOrder::BackAndForth, 0));
  EXPECT_EQ(forwards, top_after(PassOrder::BackAndForth, 1));
}

TEST(Quality, AccurateIsTheDefault) {
  EXPECT_TRUE(has_quality(WorldSettings{}, Quality::Accurate));
  EXPECT_FALSE(has_quality(WorldSettings{}, Quality::Game));
}

TEST(Quality, ChangesWhatItDeterminesAndNothingElse) {
  WorldSettings settings;
  settings.gravity = {0, 0, -1};
  settings.restitution_threshold = 2;
  settings.substeps = 17;
  EXPECT_FALSE(has_quality(settings, Quality::Accurate));
  set_quality(settings, Quality::Game);
  EXPECT_TRUE(has_quality(settings, Quality::Game));
  EXPECT_EQ(settings.gravity, Vec3(0, 0, -1));
  EXPECT_EQ(settings.restitution_threshold, 2);
  set_quality(settings, Quality::Accurate);
  EXPECT_TRUE(has_quality(settings, Quality::Accurate));
}

}  // namespace
}  // namespace cs550
