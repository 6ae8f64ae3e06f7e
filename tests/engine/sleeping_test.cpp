// Sleeping: what falls asleep, what must not, what wakes it, and that nothing else changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "engine/counted_allocations.hpp"
#include "engine/islands/sleeping.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

WorldSettings sleeping_settings(WorldSettings settings = {}) {
  settings.sleeping = true;
  return settings;
}

int sleepers(const World& world) {
  int count = 0;
  for (const RigidBody& body : world.bodies()) count += body.asleep ? 1 : 0;
  return count;
}

int moving_bodies(const World& world) {
  int count = 0;
  for (const RigidBody& body : world.bodies()) count += body.kind == BodyKind::Dynamic ? 1 : 0;
  return count;
}

/// Runs until all dynamic bodies sleep. @returns whether they do
bool falls_asleep(World& world, int most_steps) {
  for (int i = 0; i < most_steps; ++i) {
    world.step(step_length);
    if (sleepers(world) == moving_bodies(world)) return true;
  }
  return false;
}

/// Two towers of four cubes on a floor, 6 m apart, one after the other.
struct Towers {
  World world;
  BodyId floor;
  std::vector<BodyId> left, right;

  explicit Towers(const WorldSettings& settings = sleeping_settings()) : world(settings) {
    const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
    floor = world.add_body(floor_body());
    for (int i = 0; i < 4; ++i) {
      const Real height = Real(0.5) + static_cast<Real>(i);
      left.push_back(world.add_body(body_at(cube, {-3, 0, height})));
      right.push_back(world.add_body(body_at(cube, {3, 0, height})));
    }
  }

  bool is_asleep(const std::vector<BodyId>& tower) const {
    return std::all_of(tower.begin(), tower.end(),
                       [&](BodyId id) { return !world.is_alive(id) || world.body(id).asleep; });
  }
};

TEST(Sleeping, IsOffByDefault) {
  Towers towers{WorldSettings()};
  run(towers.world, 120);
  EXPECT_EQ(sleepers(towers.world), 0);
}

TEST(Sleeping, TowersSleepAndCostNoPairs) {
  Towers towers;
  ASSERT_TRUE(falls_asleep(towers.world, 120));
  const std::uint64_t hash = towers.world.state_hash();
  run(towers.world, 60);
  EXPECT_EQ(towers.world.state_hash(), hash) << "a sleeping body moved";
  const StepStats& stats = towers.world.stats();
  EXPECT_EQ(stats.asleep, 8);
  EXPECT_EQ(stats.pairs, 0);
  EXPECT_EQ(stats.points, 0);
  EXPECT_TRUE(towers.world.began().empty());
  EXPECT_TRUE(towers.world.ended().empty());
}

TEST(Sleeping, ContactsOfSleepersAreKeptWithTheirImpulses) {
  Towers towers;
  ASSERT_TRUE(falls_asleep(towers.world, 120));
  // Four contacts in each tower. The lowest carries the weight of four cubes for one substep.
  int touching = 0;
  for (const Contact& contact : towers.world.sleeping_contacts()) {
    touching += contact.manifold.points.empty() ? 0 : 1;
    if (contact.body_a != towers.floor.index || contact.body_b != towers.left[0].index) continue;
    Real impulse = 0;
    for (const ContactPoint& point : contact.manifold.points) impulse += point.normal_impulse;
    const Real substep = step_length / static_cast<Real>(towers.world.settings().substeps);
    const Real weight = 4 * 1000 * Real(9.81);
    EXPECT_NEAR(impulse, weight * substep, Real(0.02) * weight * substep);
  }
  EXPECT_EQ(touching, 8);
}

TEST(Sleeping, HullsInAHeapSleepWithinSeconds) {
  World world = falling_hulls(12, 5);
  world.settings() = sleeping_settings(game_settings());
  world.settings().check_stages = true;
  EXPECT_TRUE(falls_asleep(world, 1200)) << sleepers(world) << " of 12 sleep";
  EXPECT_TRUE(world.problems().empty());
}

// ---- What must not sleep ----------------------------------------------------------------------

/// Compares a run with sleeping to one without. Until a body sleeps both are the same to the last bit.
void expect_same_run(const std::function<World(const WorldSettings&)>& make, int steps) {
  WorldSettings settings;
  World awake = make(settings);
  World sleeping = make(awake.settings());
  sleeping.settings().sleeping = true;
  for (int i = 0; i < steps; ++i) {
    awake.step(step_length);
    sleeping.step(step_length);
    ASSERT_EQ(sleepers(sleeping), 0) << "in step " << i;
    World without_windows = sleeping;  // the hash contains them only with the setting
    without_windows.settings().sleeping = false;
    ASSERT_EQ(awake.state_hash(), without_windows.state_hash()) << "in step " << i;
  }
}

/// Cubes that fall from a height, each turned a little more than the one below and `growth` times as wide.
World dropped_stack(const WorldSettings& settings, int cubes, Real height, Real turn,
                    Real growth = 1) {
  World world(settings);
  world.add_body(floor_body());
  Real half = Real(0.5);
  Real top = height;
  for (int i = 0; i < cubes; ++i) {
    BodyDef def = body_at(box_shape(Vec3::Constant(half)), {0, 0, top + half});
    def.pose.orientation = Quat(Eigen::AngleAxis<Real>(turn * static_cast<Real>(i), Vec3::UnitZ()));
    world.add_body(def);
    top += 2 * half;
    half *= growth;
  }
  return world;
}

// Three cubes that are solved without over-relaxation may swing by a third of a millimetre for minutes.
TEST(Sleeping, StacksThatWereDroppedComeToRestLong) {
  for (const WorldSettings& named : {accurate_settings(), game_settings()}) {
    for (const int cubes : {3, 4, 5, 8}) {
      for (const Real turn : {Real(0), Real(0.1)}) {
        for (int i = 0; i < 20; ++i) {
          const Real height = Real(0.25) * static_cast<Real>(i);
          World world = dropped_stack(sleeping_settings(named), cubes, height, turn);
          EXPECT_TRUE(falls_asleep(world, 20 * 60))
              << cubes << " cubes from " << height << " m, turned by " << turn << ", "
              << named.substeps << " substeps";
        }
      }
    }
  }
}

// Without over-relaxation `game` leaves four of the ten stacks of four cubes awake.
TEST(Sleeping, StacksThatBecomeHeavierUpwardsComeToRestLong) {
  for (const WorldSettings& named : {accurate_settings(), game_settings()}) {
    for (const int cubes : {2, 3, 4, 6}) {
      for (int i = 0; i < 10; ++i) {
        const Real height = Real(0.35) * static_cast<Real>(i);
        World world = dropped_stack(sleeping_settings(named), cubes, height, Real(0.07), Real(1.1));
        EXPECT_TRUE(falls_asleep(world, 25 * 60))
            << cubes << " cubes from " << height << " m, " << named.substeps << " substeps";
      }
    }
  }
}

TEST(Sleeping, AGlidingBoxNeverSleeps) {
  for (const Real speed : {Real(0.005), Real(0.001)}) {
    SCOPED_TRACE(speed);
    expect_same_run(
        [&](const WorldSettings& settings) {
          World world(settings);
          BodyDef ice = floor_body();
          ice.friction = 0;
          world.add_body(ice);
          BodyDef box = body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, Real(0.5)});
          box.linear_velocity = {speed, 0, 0};
          world.add_body(box);
          return world;
        },
        300);
  }
}

TEST(Sleeping, ASlowTumblingBodyNeverSleeps) {
  // About its intermediate axis (Dzhanibekov), at 1 mm/s on the surface.
  expect_same_run(
      [](const WorldSettings& settings) {
        World world(settings);
        world.settings().gravity.setZero();
        BodyDef body = body_at(box_shape({Real(0.5), Real(0.3), Real(0.1)}), {0, 0, 0});
        body.angular_velocity = {Real(1e-5), Real(2e-3), 0};
        world.add_body(body);
        return world;
      },
      300);
}

TEST(Sleeping, ADriftingBodyNeverSleepsHoweverSlowItIs) {
  expect_same_run(
      [](const WorldSettings& settings) {
        World world(settings);
        world.settings().gravity.setZero();
        BodyDef body = body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, 0});
        body.linear_velocity = {0, Real(1e-5), 0};
        world.add_body(body);
        return world;
      },
      300);
}

TEST(Sleeping, ATowerStaysAwakeWhileItsTopMovesByAMillimetreASecond) {
  expect_same_run(
      [](const WorldSettings& settings) {
        Towers towers{settings};
        BodyDef top = body_at(box_shape({1, Real(0.5), Real(0.1)}), {-3, 0, Real(4.1)});
        top.friction = 0;
        top.linear_velocity = {Real(1e-3), 0, 0};
        towers.world.add_body(top);
        for (const BodyId id : towers.right) towers.world.remove_body(id);
        return towers.world;
      },
      300);
}

TEST(Sleeping, ABoxBalancedOnItsEdgeFalls) {
  // It starts without velocity, a tenth of a millimetre beside the unstable equilibrium, and moves by
  // less than a millimetre in the first half second.
  World world(sleeping_settings());
  world.add_body(floor_body());
  BodyDef box = body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, std::sqrt(Real(0.5))});
  box.pose.orientation = Quat(Eigen::AngleAxis<Real>(pi / 4 + Real(1.5e-4), Vec3::UnitY()));
  const BodyId id = world.add_body(box);
  run(world, 300);
  EXPECT_LT(world.body(id).pose.position.z(), Real(0.51)) << "it should lie on a face";
  EXPECT_TRUE(world.body(id).asleep);
}

TEST(Sleeping, APushedBodyStaysAwake) {
  Towers towers;
  for (int i = 0; i < 120; ++i) {
    towers.world.body(towers.left[3]).force = {1, 0, 0};
    towers.world.step(step_length);
  }
  EXPECT_FALSE(towers.world.body(towers.left[0]).asleep);
  EXPECT_TRUE(towers.is_asleep(towers.right));
}

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
TEST(Sleeping, ABodyThatIsAboutToSleepKeepsAnImpulse) {
  AwakeCube pushed;
  apply_impulse(pushed.body(), {0, 0, 5000}, {0, 0, Real(0.5)});
  run(pushed.world, 2);
  EXPECT_NEAR(pushed.body().linear_velocity.z(), 5 - 2 * 9.81 / 60, 1e-3);
}

TEST(Sleeping, ABodyThatIsAboutToSleepFallsFromANewPose) {
  AwakeCube lifted;
  lifted.body().pose.position.z() += 5;
  set_velocity(lifted.body(), Vec3::Zero(), Vec3::Zero());
  run(lifted.world, 30);
  EXPECT_LT(lifted.body().linear_velocity.z(), Real(-4));
}

TEST(Sleeping, ABodyThatIsAboutToSleepFollowsNewSettings) {
  AwakeCube cube;
  cube.world.settings().gravity.z() *= -1;
  run(cube.world, 30);
  EXPECT_GT(cube.body().linear_velocity.z(), Real(4));
}

TEST(Sleeping, ABodyThatWasHeldInTheAirFallsWhenItIsLetGo) {
  World world(sleeping_settings());
  const BodyId held = world.add_body(body_at(box_shape(Vec3::Constant(Real(0.5))), {0, 0, 5}));
  for (int i = 0; i < 60; ++i) {
    world.body(held).force = -world.body(held).mass * world.settings().gravity;
    world.step(step_length);
  }
  run(world, 60);
  EXPECT_LT(world.body(held).pose.position.z(), Real(0.2)) << "a second of free fall";
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

TEST(Sleeping, ABodyThatIsAboutToSleepFallsIfItsFloorIsRemoved) {
  CubeBesideAWall cube;
  cube.world.remove_body(cube.floor);
  cube.expect_fall();
}

TEST(Sleeping, ABodyThatIsAboutToSleepFallsIfItsFloorIsMoved) {
  CubeBesideAWall cube;
  cube.world.body(cube.floor).pose.position.z() -= 20;
  cube.expect_fall();
}

TEST(Sleeping, SwitchedOnItLetsNothingSleepAtOnce) {
  AwakeCube cube;
  cube.world.settings().sleeping = false;
  set_velocity(cube.body(), {2, 0, 0}, Vec3::Zero());
  run(cube.world, 2);
  cube.world.settings().sleeping = true;
  cube.world.step(step_length);
  EXPECT_GT(cube.body().linear_velocity.x(), Real(1.5));
}

TEST(Sleeping, TheCriterionFollowsTheLengthUnit) {
  // 1 mm/s is slow for bodies of 10 m, and fast for those of 1 cm: 4e-4 length units in half a second.
  for (const Real unit : {Real(0.01), Real(1), Real(10)}) {
    for (const Real part : {Real(0.8), Real(1.2)}) {
      WorldState state;
      state.settings.sleeping = true;
      state.settings.length_unit = unit;
      state.bodies.push_back(make_dynamic_body(1, Mat3::Identity(), {}));
      state.definitions.push_back(body_at(box_shape(Vec3::Constant(unit)), {0, 0, 0}));
      state.slots.push_back({0, true, no_index, {}});
      state.sleeping.bodies.resize(1);
      restart_window(state.bodies[0], state.sleeping.bodies[0]);
      const Real speed = part * quiet_distance * unit / quiet_time;
      for (int i = 0; i < 60; ++i) {
        state.bodies[0].pose.position.x() += speed * step_length;
        watch_rest(state, step_length);
      }
      EXPECT_EQ(state.sleeping.bodies[0].settled, part < 1) << unit;
    }
  }
}

// ---- What wakes -------------------------------------------------------------------------------

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

TEST(Sleeping, AFlagThatTheProgramSetsIsIgnored) {
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

TEST(Sleeping, AKinematicBodyThatBeginsToMoveWakesWhatItCarries) {
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

TEST(Sleeping, ABodyPassingAtADistanceWakesNothing) {
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

// ---- Determinism and cost ---------------------------------------------------------------------

TEST(Sleeping, ACopyOfASleepingWorldContinuesIdentically) {
  World world = falling_hulls(8, 3);
  world.settings() = sleeping_settings(game_settings());
  run(world, 100);
  for (int round = 0; round < 8; ++round) {
    World copy = world;
    for (World* each : {&world, &copy}) {
      BodyDef thrown = body_at(box_shape(Vec3::Constant(Real(0.2))), {-5, 0, Real(0.5)});
      thrown.linear_velocity = {Real(8), 0, 1};
      each->add_body(thrown);
      run(*each, 90);
    }
    ASSERT_EQ(world.state_hash(), copy.state_hash()) << "round " << round;
    ASSERT_EQ(sleepers(world), sleepers(copy));
  }
}

TEST(Sleeping, HashSeesHowLongABodyHasBeenAtRest) {
  // Both towers are the same to the last bit, but one has been watched for a quarter of a second longer.
  Towers early;
  Towers late{WorldSettings()};
  run(early.world, 15);
  run(late.world, 15);
  late.world.settings().sleeping = true;
  run(early.world, 1);
  run(late.world, 1);
  for (const BodyId id : early.left) {
    EXPECT_EQ(early.world.body(id).pose.position, late.world.body(id).pose.position);
  }
  EXPECT_NE(early.world.state_hash(), late.world.state_hash());
}

TEST(Sleeping, EventsAreThoseOfAWorldWithoutSleeping) {
  // Contacts of sleepers neither end nor begin: at the end as many have begun as touch.
  Towers towers;
  int balance = 0;
  for (int i = 0; i < 240; ++i) {
    if (i == 120) towers.world.remove_body(towers.left[3]);
    towers.world.step(step_length);
    balance += static_cast<int>(towers.world.began().size());
    balance -= static_cast<int>(towers.world.ended().size());
  }
  EXPECT_EQ(balance, 7);
}

TEST(Sleeping, ASleepingWorldAllocatesNothing) {
  Towers towers;
  ASSERT_TRUE(falls_asleep(towers.world, 120));
  run(towers.world, 2);
  const long before = allocation_count();
  run(towers.world, 10);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace cs550
