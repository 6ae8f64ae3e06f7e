// Sleeping: what wakes, and what keeps a body at rest from falling asleep.

#include <gtest/gtest.h>

#include "engine/sleeping_worlds.hpp"

namespace cs550 {
namespace {

using namespace test;

// ---- Bodies at rest that are still awake ------------------------------------------------------

/// Runs until the next step would put the first bodies to sleep.
void run_until_drowsy(World& world) {
  World next = world;
  for (int i = 0; i < 240; ++i) {
    next.step(step_length);
    if (sleepers(next) > 0) return;
    world = next;
  }
  FAIL() << "nothing falls asleep";
}

/// A cube on a floor that is at rest, but still awake.
struct AwakeCube {
  World world{sleeping_settings()};
  BodyId cube;

  AwakeCube() {
    world.add_body(floor_body());
    cube = world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, Real(0.5)}));
    run_until_drowsy(world);
  }

  RigidBody& body() { return world.body(cube); }
};

// It has been at rest for long when it is disturbed, but awake.
TEST(Waking, ABodyThatIsAboutToSleepKeepsAnImpulse) {
  AwakeCube pushed;
  apply_impulse(pushed.body(), {0, 0, 5000}, {0, 0, Real(0.5)});
  run(pushed.world, 2);
  EXPECT_NEAR(pushed.body().linear_velocity.z(), 5 - 2 * 9.81 / 60, 1e-3);
}

TEST(Waking, ABodyThatIsAboutToSleepFallsFromANewPose) {
  AwakeCube lifted;
  lifted.body().pose.position.z() += 5;
  set_velocity(lifted.body(), Vec3::Zero(), Vec3::Zero());
  run(lifted.world, 30);
  EXPECT_LT(lifted.body().linear_velocity.z(), Real(-4));
}

TEST(Waking, ABodyThatIsAboutToSleepFollowsNewSettings) {
  AwakeCube cube;
  cube.world.settings().gravity.z() *= -1;
  run(cube.world, 30);
  EXPECT_GT(cube.body().linear_velocity.z(), Real(4));
}

TEST(Waking, ABodyThatWasHeldInTheAirFallsWhenItIsLetGo) {
  World world(sleeping_settings());
  const BodyId held = world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, 5}));
  for (int i = 0; i < 60; ++i) {
    world.body(held).force = -world.body(held).mass * world.settings().gravity;
    world.step(step_length);
  }
  run(world, 60);
  EXPECT_LT(world.body(held).pose.position.z(), Real(0.2)) << "a second of free fall";
}

// It falls by less than 2 mm in each step, to the same pose. The wall beside it has contact points, but is no support.
TEST(Waking, ABodyThatWasHeldAtAPoseFallsWhenItIsLetGo) {
  const ShapePtr box = box_shape(Vec3::Constant(Real(0.5)));
  for (int held_steps = 1; held_steps <= 70; ++held_steps) {
    World world(sleeping_settings());
    world.add_body(body_at(box, {Real(1.001), 0, 5}, BodyKind::Static));
    const BodyId held = world.add_body(body_at(box, {0, 0, 5}));
    for (int i = 0; i < held_steps; ++i) {
      world.body(held).pose = world.definition(held).pose;
      set_velocity(world.body(held), Vec3::Zero(), Vec3::Zero());
      world.step(step_length);
    }
    run(world, 60);
    EXPECT_LT(world.body(held).pose.position.z(), Real(0.2)) << "held for " << held_steps;
  }
}

/// A drowsy cube on a floor, and a wall 1 mm beside it: near enough for contact points, but no support.
struct CubeBesideAWall {
  World world{sleeping_settings()};
  BodyId floor, cube;

  CubeBesideAWall() {
    const ShapePtr box = box_shape(Vec3::Constant(Real(0.5)));
    floor = world.add_body(floor_body());
    world.add_body(body_at(box, {Real(1.001), 0, Real(0.5)}, BodyKind::Static));
    cube = world.add_body(body_at(box, {0, 0, Real(0.5)}));
    run_until_drowsy(world);
  }

  void expect_fall() {
    run(world, 60);
    EXPECT_LT(world.body(cube).pose.position.z(), Real(-3));
  }
};

TEST(Waking, ABodyThatIsAboutToSleepFallsIfItsFloorIsRemoved) {
  CubeBesideAWall cube;
  cube.world.remove_body(cube.floor);
  cube.expect_fall();
}

TEST(Waking, ABodyThatIsAboutToSleepFallsIfItsFloorIsMoved) {
  CubeBesideAWall cube;
  cube.world.body(cube.floor).pose.position.z() -= 20;
  cube.expect_fall();
}

// The lower cube is awake because it is pushed all the time. The wall is no support, but has contact points.
TEST(Waking, ABodyThatIsAboutToSleepFallsIfTheBodyBelowIsMovedAway) {
  World world(sleeping_settings());
  const ShapePtr box = box_shape(Vec3::Constant(Real(0.5)));
  world.add_body(floor_body());
  world.add_body(body_at(box, {Real(1.001), 0, Real(1.5)}, BodyKind::Static));
  const BodyId below = world.add_body(body_at(box, {0, 0, Real(0.5)}));
  const BodyId above = world.add_body(body_at(box, {0, 0, Real(1.5)}));
  for (int i = 0; i < 180; ++i) {
    world.body(below).force = {0, 1, 0};
    world.step(step_length);
  }
  world.body(below).pose.position.y() = 20;
  run(world, 60);
  EXPECT_NEAR(world.body(above).pose.position.z(), Real(0.5), Real(0.01));
}

TEST(Waking, SwitchedOnItLetsNothingSleepAtOnce) {
  AwakeCube cube;
  cube.world.settings().sleeping = false;
  set_velocity(cube.body(), {2, 0, 0}, Vec3::Zero());
  run(cube.world, 2);
  cube.world.settings().sleeping = true;
  cube.world.step(step_length);
  EXPECT_GT(cube.body().linear_velocity.x(), Real(1.5));
}

// ---- Bodies asleep ----------------------------------------------------------------------------

/// Two towers asleep; something happens to the left one.
class WakingTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(falls_asleep(towers.world, 120)); }

  void expect_only_left_wakes() {
    towers.world.step(step_length);
    for (const BodyId id : towers.left) {
      EXPECT_FALSE(towers.world.is_alive(id) && towers.world.body(id).asleep);
    }
    EXPECT_TRUE(towers.is_asleep(towers.right));
  }

  Towers towers;
};

TEST_F(WakingTest, AnImpulse) {
  apply_impulse(towers.world.body(towers.left[1]), {0, 0, Real(1e-3)}, {-3, 0, Real(1.5)});
  expect_only_left_wakes();
}

// Momenta are the state; velocities follow from them.
TEST_F(WakingTest, NotAVelocityThatTheProgramWrites) {
  RigidBody& body = towers.world.body(towers.left[3]);
  body.linear_velocity = {30, 0, 0};
  towers.world.step(step_length);
  EXPECT_TRUE(towers.is_asleep(towers.left));
  EXPECT_TRUE(body.linear_velocity.isZero(0));
}

TEST_F(WakingTest, AForce) {
  towers.world.body(towers.left[2]).force = {0, 1, 0};
  expect_only_left_wakes();
}

TEST_F(WakingTest, ANewPose) {
  towers.world.body(towers.left[3]).pose.position.z() += Real(0.1);
  expect_only_left_wakes();
}

TEST_F(WakingTest, AFlagThatTheProgramClears) {
  towers.world.body(towers.left[2]).asleep = false;
  expect_only_left_wakes();
}

TEST(Waking, AFlagThatTheProgramSetsIsIgnored) {
  Towers towers;
  towers.world.body(towers.left[3]).pose.position.z() = 5;
  towers.world.body(towers.left[3]).asleep = true;
  run(towers.world, 30);
  EXPECT_LT(towers.world.body(towers.left[3]).pose.position.z(), Real(4.5));
}

TEST_F(WakingTest, ABodyThatLandsOnIt) {
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  towers.world.add_body(body_at(cube, {-3, 0, Real(5.5)}));
  int steps = 0;
  while (towers.is_asleep(towers.left) && ++steps < 60) towers.world.step(step_length);
  EXPECT_LT(steps, 60);
  EXPECT_TRUE(towers.is_asleep(towers.right));
  // It falls by 1 m; the tower is awake before they touch.
  EXPECT_GE(towers.world.stats().deepest_separation, Real(-2e-3));
}

TEST_F(WakingTest, RemovalOfItsSupport) {
  towers.world.remove_body(towers.left[0]);
  expect_only_left_wakes();
  run(towers.world, 120);
  EXPECT_NEAR(towers.world.body(towers.left[3]).pose.position.z(), Real(2.5), Real(0.01));
}

TEST_F(WakingTest, RemovalOfTheFloor) {
  towers.world.remove_body(towers.floor);
  towers.world.step(step_length);
  EXPECT_EQ(sleepers(towers.world), 0);
  run(towers.world, 59);
  // A second of free fall.
  EXPECT_NEAR(towers.world.body(towers.left[0]).pose.position.z(), Real(0.5) - Real(4.9),
              Real(0.1));
}

TEST_F(WakingTest, AFloorThatWasMoved) {
  towers.world.body(towers.floor).pose.position.z() -= Real(0.5);
  towers.world.step(step_length);
  EXPECT_EQ(sleepers(towers.world), 0);
  run(towers.world, 120);
  EXPECT_NEAR(towers.world.body(towers.right[0]).pose.position.z(), 0, Real(0.01));
}

TEST_F(WakingTest, ASettingThatChanges) {
  towers.world.settings().gravity.x() = 3;
  towers.world.step(step_length);
  EXPECT_EQ(sleepers(towers.world), 0);
}

TEST_F(WakingTest, NothingWhenThreadsOrChecksChange) {
  World untouched = towers.world;
  WorldSettings& settings = towers.world.settings();
  settings.threads = 2;
  settings.adaptive_threads = false;
  settings.check_stages = true;
  settings.audit_momentum = true;
  for (int i = 0; i < 3; ++i) {
    towers.world.step(step_length);
    untouched.step(step_length);
    EXPECT_EQ(sleepers(towers.world), 8);
    EXPECT_EQ(towers.world.state_hash(), untouched.state_hash());
  }
}

TEST_F(WakingTest, SleepingSwitchedOff) {
  towers.world.settings().sleeping = false;
  towers.world.step(step_length);
  EXPECT_EQ(sleepers(towers.world), 0);
  EXPECT_EQ(towers.world.stats().contacts, 8);
}

TEST_F(WakingTest, NothingWakesAgainAndAgain) {
  apply_impulse(towers.world.body(towers.left[1]), {1, 0, 0}, {-3, 0, Real(1.5)});
  EXPECT_TRUE(falls_asleep(towers.world, 240));
  for (int i = 0; i < 120; ++i) {
    towers.world.step(step_length);
    ASSERT_EQ(sleepers(towers.world), 8);
  }
}

TEST(Waking, AKinematicBodyThatBeginsToMoveWakesWhatItCarries) {
  World world(sleeping_settings());
  const ShapePtr slab = box_shape({2, 2, Real(0.1)});
  const BodyId lift = world.add_body(body_at(slab, {0, 0, Real(-0.1)}, BodyKind::Kinematic));
  const BodyId box =
      world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, Real(0.5)}));
  ASSERT_TRUE(falls_asleep(world, 120));
  set_velocity(world.body(lift), {0, 0, Real(0.2)}, {0, 0, 0});
  run(world, 60);
  EXPECT_FALSE(world.body(box).asleep) << "what moves with its support is not at rest";
  EXPECT_NEAR(world.body(box).pose.position.z(), Real(0.7), Real(0.01));
  set_velocity(world.body(lift), {0, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(falls_asleep(world, 120));
}

TEST(Waking, ABodyPassingAtADistanceWakesNothing) {
  Towers towers;
  ASSERT_TRUE(falls_asleep(towers.world, 120));
  BodyDef passing = body_at(box_shape(Vec3::Constant(Real(0.2))), {-6, 1, Real(0.2)});
  passing.linear_velocity = {6, 0, 0};
  passing.friction = 0;
  towers.world.add_body(passing);
  for (int i = 0; i < 60; ++i) {
    towers.world.step(step_length);
    ASSERT_EQ(sleepers(towers.world), 8) << "in step " << i;
  }
}

}  // namespace
}  // namespace cs550
