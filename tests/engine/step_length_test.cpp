// Steps of different lengths, one after the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

// With the same impulses for longer and shorter substeps the top moves by 0.04 m/s for as long as it stands.
TEST(StepLength, StepsOfDifferentLengthDoNotShakeATower) {
  World world;
  world.add_body(floor_body());
  BodyId top;
  for (int i = 0; i < 8; ++i) {
    top = world.add_body(body_at(unit_box(), {0, 0, Real(0.5) + static_cast<Real>(i)}));
  }
  Random random(3);
  Real fastest = 0;
  for (int i = 0; i < 1200; ++i) {
    world.step(step_length * random.real(Real(0.8), Real(1.2)));
    if (i >= 600) fastest = std::max(fastest, world.body(top).linear_velocity.norm());
  }
  EXPECT_LT(fastest, Real(0.01));
}

/// A cube that lands flat in the last substep of a step (s), and takes another step.
World landed_cube(Real first, Real second) {
  World world;
  world.add_body(floor_body());
  const Real substep = first / static_cast<Real>(world.settings().substeps);
  BodyDef def = body_at(unit_box(), {0, 0, Real(0.5) + 5 * (first - substep)});
  def.linear_velocity.z() = -5;
  world.add_body(def);
  world.step(first);
  world.step(second);
  return world;
}

// Weight pushes for as long as the substep lasts, but a blow does not.
TEST(StepLength, ALongerStepDoesNotRepeatABlow) {
  for (const auto& [first, second] :
       {std::pair(Real(1e-3), Real(0.05)), {Real(1e-6), step_length}, {step_length, step_length}}) {
    const World world = landed_cube(first, second);
    EXPECT_LT(world.bodies()[1].pose.position.z(), Real(0.52)) << first << " s, then " << second;
  }
}

// The impulses of sleeping bodies carry weight only. What they are worth follows the step both ways.
TEST(StepLength, ALongStepInBetweenLeavesSleepersAsTheyWere) {
  World world;
  world.settings().sleeping = true;
  world.add_body(floor_body());
  world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  run(world, 120);
  ASSERT_EQ(world.stats().asleep, 1);
  World other = world;
  for (const Real factor : {1, 1, 1}) world.step(factor * step_length);
  for (const Real factor : {1, 2, 1}) other.step(factor * step_length);
  EXPECT_EQ(world.state_hash(), other.state_hash());
}

/// A tower of three cubes that fell asleep in steps of 1/60 s.
World sleeping_tower() {
  World world;
  world.settings().sleeping = true;
  world.add_body(floor_body());
  for (int i = 0; i < 3; ++i) world.add_body(body_at(unit_box(), {0, 0, Real(0.5) + Real(i)}));
  run(world, 180);
  EXPECT_EQ(world.stats().asleep, 3);
  return world;
}

// A step visits no contact of theirs. It would also leave a rounding error each time.
TEST(StepLength, LeavesTheImpulsesOfSleepersAlone) {
  World world = sleeping_tower();
  const std::vector<Contact> before(world.sleeping_contacts().begin(),
                                    world.sleeping_contacts().end());
  for (const Real factor : {0.9, 1.3, 0.7}) world.step(factor * step_length);
  ASSERT_EQ(world.sleeping_contacts().size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Manifold& now = world.sleeping_contacts()[i].manifold;
    for (int k = 0; k < now.points.size(); ++k) {
      EXPECT_EQ(now.points[k].normal_impulse, before[i].manifold.points[k].normal_impulse);
    }
  }
}

// Without passes, a step leaves the impulses with which it begins.
TEST(StepLength, SleepersThatWakeInALongerStepHaveTheirWholeLoad) {
  World world = sleeping_tower();
  const std::vector<Contact> before(world.sleeping_contacts().begin(),
                                    world.sleeping_contacts().end());
  for (int i = 0; i < 3; ++i) world.step(2 * step_length);
  world.settings().iterations = 0;
  world.settings().relax_iterations = 0;
  world.step(2 * step_length);
  ASSERT_EQ(world.contacts().size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Manifold& now = world.contacts()[i].manifold;
    ASSERT_EQ(now.points.size(), before[i].manifold.points.size());
    for (int k = 0; k < now.points.size(); ++k) {
      EXPECT_EQ(now.points[k].normal_impulse, 2 * before[i].manifold.points[k].normal_impulse);
    }
  }
}

TEST(StepLength, StaysFiniteAfterTheShortestStep) {
  for (const ContactModel model : {ContactModel::Soft, ContactModel::Baumgarte}) {
    World world;
    world.settings().contact_model = model;
    world.add_body(floor_body());
    world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
    run(world, 10);
    world.step(Real(1e-30));
    run(world, 10);
    EXPECT_TRUE(is_finite(world));
    EXPECT_NEAR(world.bodies()[1].pose.position.z(), 0.5, 1e-2);
  }
}

TEST(StepLength, RefusesAStepThatIsNoTime) {
  World world = falling_hulls(3, 12);
  run(world, 10);
  const std::uint64_t before = world.state_hash();
  for (const Real h : {Real(0), Real(-1) / 60, Real(0.9e-30), std::numeric_limits<Real>::infinity(),
                       std::numeric_limits<Real>::quiet_NaN()}) {
    EXPECT_THROW(world.step(h), std::invalid_argument) << h;
  }
  EXPECT_EQ(world.state_hash(), before);
  EXPECT_EQ(world.step_count(), 10);
}

}  // namespace
}  // namespace cs550
