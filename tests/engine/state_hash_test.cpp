// World::state_hash() sees whatever a world hands from step to step.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

TEST(StateHash, SeesTheLastBitOfEveryBody) {
  World world = falling_hulls(3, 15);
  const std::uint64_t before = world.state_hash();
  Real& x = world.body(world.id_at(2)).pose.position.x();
  x = std::nextafter(x, Real(100));
  EXPECT_NE(world.state_hash(), before);
}

/// Two boxes on each other on a floor.
World two_boxes() {
  World world;
  world.add_body(floor_body());
  world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  world.add_body(body_at(unit_box(), {Real(0.2), 0, Real(1.5)}));
  return world;
}

TEST(StateHash, SeesWhatContactsKeep) {
  World rested = two_boxes();
  run(rested, 60);
  World fresh = two_boxes();
  for (Index i = 1; i <= 2; ++i) {
    const RigidBody& from = rested.body(rested.id_at(i));
    RigidBody& to = fresh.body(fresh.id_at(i));
    to.pose = from.pose;
    to.linear_momentum = from.linear_momentum;
    to.angular_momentum = from.angular_momentum;
  }
  EXPECT_NE(rested.state_hash(), fresh.state_hash()) << "the fresh one has no impulses";
  // And so it continues differently.
  run(rested, 1);
  run(fresh, 1);
  EXPECT_NE(rested.body(rested.id_at(2)).linear_momentum,
            fresh.body(fresh.id_at(2)).linear_momentum);
}

/// Boxes in towers of two, apart from each other: from 64 towers on, contacts enough for two parts.
World many_towers(int towers) {
  World world;
  world.add_body(floor_body());
  for (int i = 0; i < towers; ++i) {
    const int column = i % 10;
    const int row = i / 10;
    for (const Real height : {Real(0.5), Real(1.5)}) {
      world.add_body(body_at(unit_box(), {Real(2) * Real(column), Real(2) * Real(row), height}));
    }
  }
  return world;
}

// The parts decide the solve order, and with it the last bits. They are kept for 16 steps.
TEST(StateHash, SeesHowLongPartsHaveBeenKept) {
  World world = many_towers(70);
  world.settings().gravity.setZero();  // nothing changes but the parts
  run(world, 2);
  ASSERT_EQ(world.stats().contacts, 2 * 70);
  const std::uint64_t before = world.state_hash();
  run(world, 2);
  EXPECT_NE(world.state_hash(), before);
  run(world, 14);
  EXPECT_EQ(world.state_hash(), before) << "16 steps later, and divided again";
}

TEST(StateHash, SeesWhatTheProgramHasSet) {
  World world = two_boxes();
  BodyDef lift = body_at(unit_box(), {4, 0, 3}, BodyKind::Kinematic);
  const BodyId carrier = world.add_body(lift);
  std::uint64_t before = world.state_hash();
  EXPECT_EQ(before, World(world).state_hash());
  add_force(world.body(world.id_at(1)), {1, 0, 0}, {0, 0, 0});
  EXPECT_NE(world.state_hash(), before) << "a pending force";
  before = world.state_hash();
  set_velocity(world.body(carrier), {0, 0, 1}, {0, 0, 0});
  EXPECT_NE(world.state_hash(), before) << "the velocity of a kinematic body";
}

}  // namespace
}  // namespace cs550
