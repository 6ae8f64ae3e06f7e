// Bodies and settings at the edge of what float holds: no impulse may run away.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// The largest speed of a body during a run (m/s); infinity once a number is not finite.
Real fastest_speed(World& world, int steps) {
  Real fastest = 0;
  for (int step = 0; step < steps; ++step) {
    world.step(step_length);
    if (!is_finite(world)) return std::numeric_limits<Real>::infinity();
    for (const RigidBody& body : world.bodies()) {
      fastest = std::max(fastest, body.linear_velocity.norm());
    }
  }
  return fastest;
}

/// Needles of 1 : 500 that fall onto a floor in a heap.
World needles(int count, std::uint32_t seed, Real gravity) {
  Random random(seed);
  World world;
  world.settings().gravity = {0, 0, -gravity};
  world.settings().audit_momentum = true;
  world.add_body(floor_body());
  const ShapePtr needle = box_shape({1, Real(0.002), Real(0.002)});
  for (int i = 0; i < count; ++i) {
    const Vec3 place = random.point_in_box({2, 2, 0}) + (1 + Real(0.5) * i) * Vec3::UnitZ();
    BodyDef def = body_at(needle, place);
    def.pose.orientation = random.orientation();
    world.add_body(def);
  }
  return world;
}

/// A needle turns by its thinness within a substep: masses of the substep's beginning are a hundred
/// times too large by its end.
TEST(ExtremeScenes, ThinNeedlesStayAsFastAsTheyFell) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    World world = needles(20, seed, Real(9.81));
    // The fall of the highest, of 10.5 m, ends at √(2·g·10.5 m) = 14.4 m/s. 13.9 m/s are reached.
    EXPECT_LT(fastest_speed(world, 180), Real(14.4)) << "seed " << seed;
    EXPECT_LT(world.momentum_error(), 1e-3) << "seed " << seed;
  }
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    World world = needles(1, seed, 300);
    // A fall of 1 m ends at √(2·g·1 m) = 24.5 m/s. One end arrives earlier: 20 m/s are reached.
    EXPECT_LT(fastest_speed(world, 120), Real(24.5)) << "seed " << seed;
  }
}

/// A free body keeps its energy. A turn of 100 rad/s changes it, up or down, by a part that depends on the
/// direction of the spin, which then stays much the same for many turns.
TEST(ExtremeScenes, AFastSpinKeepsItsEnergyForTwoSeconds) {
  const ShapePtr board = box_shape({Real(0.2), Real(0.5), 1});
  for (std::uint32_t seed = 1; seed <= 32; ++seed) {
    Random random(seed);
    World world(game_settings());
    world.settings().gravity.setZero();
    BodyDef def = body_at(board, Vec3::Zero());
    def.angular_velocity = random.real(10, 100) * random.unit_vector();
    world.add_body(def);
    const double start = energy(world, 0).kinetic;
    const double momentum = angular_momentum(world).norm();
    run(world, 120);
    EXPECT_NEAR(energy(world, 0).kinetic, start, 0.005 * start) << "seed " << seed;
    EXPECT_NEAR(angular_momentum(world).norm(), momentum, 1e-3 * momentum) << "seed " << seed;
  }
}

/// Impulses that were carried to a contact whose mass has become much smaller.
TEST(ExtremeScenes, BaumgarteAtAHundredTimesGravityStaysFinite) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    World world;
    world.settings().contact_model = ContactModel::Baumgarte;
    world.settings().gravity = {0, 0, -1000};
    world.add_body(floor_body());
    for (int i = 0; i < 40; ++i) {
      const ShapePtr hull = random_hull(random, 12, Vec3::Constant(Real(0.5)));
      const Vec3 place = random.point_in_box(Vec3::Constant(Real(0.4))) + 2 * Vec3::UnitZ();
      BodyDef def = body_at(hull, place);
      def.friction = 1000;
      world.add_body(def);
    }
    // A body that leaves the floor falls at up to 2000 m/s in the end.
    EXPECT_LT(fastest_speed(world, 120), 4000) << "seed " << seed;
  }
}

/// Two to four boxes of 10 µm to 1 cm in each other, at up to 1000 km/s: in a step they part by a hundred
/// million lengths.
World fast_specks(std::uint32_t seed) {
  Random random(seed);
  const auto power_of_ten = [&](Real least, Real most) {
    return std::pow(Real(10), random.real(least, most));
  };
  World world;
  if (seed % 2 == 0) world.settings().contact_model = ContactModel::Baumgarte;
  const Real size = power_of_ten(-5, -2);
  for (int count = random.integer(2, 4); count > 0; --count) {
    const Vec3 part(random.real(Real(0.1), 1), random.real(Real(0.1), 1),
                    random.real(Real(0.1), 1));
    BodyDef def = body_at(box_shape(size * part), random.point_in_box(Vec3::Constant(size)));
    def.linear_velocity = power_of_ten(-2, 6) * random.unit_vector();
    def.angular_velocity = power_of_ten(-2, 6) * random.unit_vector();
    world.add_body(def);
  }
  return world;
}

/// A lever that ends halfway between bodies that have parted is kilometres long. The response to an impulse there
/// grows with its square, friction multiplies two of them, and float ends at 3.4e38.
TEST(ExtremeScenes, SpecksThatPartByManyLengthsStayFinite) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    World world = fast_specks(seed);
    EXPECT_LT(fastest_speed(world, 4), 4e6F) << "seed " << seed;
  }
}

TEST(ExtremeScenes, ALostStepNamesStageBodyAndStep) {
  World world;
  world.add_body(floor_body());
  const BodyId box = world.add_body(body_at(box_shape({1, 1, 1}), {0, 0, 5}));
  run(world, 3);
  world.body(box).force.x() = std::numeric_limits<Real>::infinity();
  const World before = world;
  world.step(step_length);
  EXPECT_FALSE(is_finite(world));
  EXPECT_TRUE(is_finite(before));
  const std::vector<StageProblem> broken = find_broken_stages(before, step_length);
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].stage, Stage::Integrate);
  EXPECT_EQ(broken[0].body, box.index);
  EXPECT_EQ(broken[0].step, 3);
}

/// The world inverse inertia of a needle is rounded by more than its smallest eigenvalue, so the energy of a turn may round
/// to less than nothing.
TEST(ExtremeScenes, ThinNeedlesThatTurnStayFinite) {
  Random random(23);
  World world;
  world.settings().gravity.setZero();
  for (int i = 0; i < 50; ++i) {
    BodyDef def = body_at(box_shape({1, Real(1e-4), Real(1e-4)}), {0, 0, static_cast<Real>(4 * i)});
    def.pose.orientation = random.orientation();
    def.angular_velocity = def.pose.orientation * Vec3(0, 1, 0);
    world.add_body(def);
  }
  run(world, 120);
  EXPECT_TRUE(is_finite(world));
}

// NaN impulses that contacts kept would lose the body again in each step, and lab 7 would be named for it.
TEST(ExtremeScenes, ALostStepIsUndone) {
  for (const bool sleeping : {false, true}) {
    World world;
    world.settings().check_stages = true;
    world.settings().audit_momentum = true;
    world.settings().sleeping = sleeping;
    world.add_body(floor_body());
    const BodyId box = world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
    const BodyId upper = world.add_body(body_at(unit_box(), {0, 0, Real(1.5)}));
    run(world, 20);
    const Pose before = world.body(upper).pose;
    world.body(box).force.x() = std::numeric_limits<Real>::infinity();
    world.step(step_length);
    ASSERT_FALSE(world.problems().empty());
    EXPECT_EQ(world.problems()[0].stage, Stage::Integrate);
    for (int step = 0; step < 60; ++step) {
      world.step(step_length);
      ASSERT_TRUE(world.problems().empty()) << step << ": " << world.problems()[0].message;
    }
    EXPECT_TRUE(is_finite(world));
    // Contacts begin without impulses, so the stack sinks and comes back.
    EXPECT_LT((world.body(upper).pose.position - before.position).norm(), 1e-3);
    EXPECT_LT(world.momentum_error(), 1e-4);
  }
}

TEST(ExtremeScenes, ALostEnergyNamesTheBody) {
  World world;
  world.add_body(floor_body());
  const BodyId box = world.add_body(body_at(box_shape({1, 1, 1}), {0, 0, 5}));
  world.body(box).force.x() = Real(1e25);  // the square of its momentum is beyond float
  const std::vector<StageProblem> broken = find_broken_stages(world, step_length);
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].body, box.index);
  EXPECT_EQ(broken[0].message, "body 1, step 0: its kinetic energy exceeds the range of float");
}

}  // namespace
}  // namespace cs550
