// Sleeping: what falls asleep, what must not, and that nothing else changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "engine/counted_allocations.hpp"
#include "engine/islands/sleeping.hpp"
#include "engine/sleeping_worlds.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {
namespace {

using namespace test;

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

// One that lab 1 breaks in every step begins each of them at the same place. Asleep, it would no longer be reported.
TEST(Sleeping, ABodyThatIsRestoredIsNotAtRest) {
  WorldState state;
  state.settings.sleeping = true;
  state.bodies.resize(1);
  state.bodies_before = state.bodies;
  state.bodies[0].pose.position.setConstant(std::numeric_limits<Real>::quiet_NaN());
  state.sleeping.bodies.resize(1);
  state.sleeping.bodies[0].settled = true;
  restore_broken_bodies(state);
  EXPECT_EQ(state.bodies[0].pose.position, Vec3(0, 0, 0));
  EXPECT_FALSE(state.sleeping.bodies[0].settled);
}

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
      state.sleeping.left.resize(1);
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
