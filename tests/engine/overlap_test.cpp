// Bodies that a scene puts into each other part, and gain no speed, whatever their friction.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// Overlap of this depth (m) is pushed apart like that of any contact: 4 slops.
constexpr Real margin = Real(0.004);
/// The speed of that push (m/s): soft contacts recover 55 times their depth in a second.
constexpr Real push = 56 * margin;

World heap_of_boxes(int count, Real friction, std::uint32_t seed) {
  Random random(seed);
  World world;
  world.settings().gravity.setZero();
  for (int i = 0; i < count; ++i) {
    BodyDef def = body_at(box_shape({Real(0.5), Real(0.5), Real(0.5)}),
                          random.point_in_box(Vec3::Constant(1)));
    def.pose.orientation = random.orientation();
    def.friction = friction;
    world.add_body(def);
  }
  return world;
}

Real largest_speed(const World& world) {
  Real largest = 0;
  for (const RigidBody& body : world.bodies()) {
    largest = std::max(largest, body.linear_velocity.norm());
  }
  return largest;
}

/// Runs a world. @returns the largest speed of a body after any step (m/s); infinity once a number is not finite
Real peak_speed(World& world, int steps) {
  Real peak = 0;
  for (int step = 0; step < steps; ++step) {
    world.step(step_length);
    if (!is_finite(world)) return std::numeric_limits<Real>::infinity();
    peak = std::max(peak, largest_speed(world));
  }
  return peak;
}

double momentum_per_mass(const World& world) {
  Vec3 momentum = Vec3::Zero();
  Real mass = 0;
  for (const RigidBody& body : world.bodies()) {
    momentum += body.linear_momentum;
    mass += body.mass;
  }
  return static_cast<double>(momentum.norm() / mass);
}

TEST(Overlap, BoxesPartWithoutSpeedWhateverTheirFrictionLong) {
  for (const Real friction : {Real(0), Real(0.6), Real(10), Real(1000)}) {
    SCOPED_TRACE(testing::Message() << "friction " << friction);
    World world = heap_of_boxes(60, friction, 1);
    world.step(step_length);
    ASSERT_LT(world.stats().deepest_separation, Real(-0.3)) << "the boxes hardly overlap";
    EXPECT_LT(peak_speed(world, 120), push);
    EXPECT_GT(world.stats().deepest_separation, -margin) << "the boxes are still in each other";
    EXPECT_LT(momentum_per_mass(world), 1e-6);
  }
}

/// Baumgarte contacts leave the speed of the push. Friction adds none to it.
TEST(Overlap, FrictionAddsNothingToABaumgartePush) {
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    const auto peak_with = [&](Real friction) {
      World world = heap_of_boxes(60, friction, seed);
      world.settings().contact_model = ContactModel::Baumgarte;
      return peak_speed(world, 60);
    };
    const Real without = peak_with(0);
    EXPECT_GT(without, 3) << "the boxes were not pushed, seed " << seed;
    // The ways of chaotic heaps differ. Where friction drove the boxes they were four times as fast.
    EXPECT_LT(peak_with(1000), Real(1.5) * without) << "seed " << seed;
  }
}

/// A push turns a spinning body, which may change the energy that belongs to its angular momentum.
TEST(Overlap, SpinningBodiesGainNoEnergyLong) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    World world;
    world.settings().gravity.setZero();
    for (int i = 0; i < 12; ++i) {
      BodyDef def = body_at(box_shape({Real(0.8), Real(0.3), Real(0.1)}),
                            random.point_in_box(Vec3::Constant(Real(0.5))));
      def.pose.orientation = random.orientation();
      def.angular_velocity = 5 * random.unit_vector();
      def.friction = 1;
      world.add_body(def);
    }
    const double before = energy(world, 0).kinetic;
    run(world, 120);
    EXPECT_LT(energy(world, 0).kinetic, 1.01 * before) << "seed " << seed;
  }
}

/// A heap on a floor with e = 1 and a friction that no material has: it falls apart, and no body
/// gets faster than a fall from the top of the heap.
TEST(Overlap, AHeapFallsApartNoFasterThanItFalls) {
  World world = heap_of_boxes(60, 1000, 1);
  world.settings().gravity = {0, 0, Real(-9.81)};
  world.settings().audit_momentum = true;
  BodyDef floor = floor_body();
  floor.pose.position.z() -= 2;
  floor.friction = 1000;
  floor.restitution = 1;
  world.add_body(floor);
  Real top = 0;
  Real peak = 0;
  for (int step = 0; step < 240; ++step) {
    world.step(step_length);
    for (const RigidBody& body : world.bodies()) top = std::max(top, body.pose.position.z() + 2);
    peak = std::max(peak, largest_speed(world));
  }
  EXPECT_LT(peak, std::sqrt(2 * Real(9.81) * top));
  EXPECT_LT(world.momentum_error(), 1e-4);
}

/// A box inside of a tower lifts what is above it, and the tower stands.
TEST(Overlap, ATowerStandsAfterABoxWasPutIntoIt) {
  World world;
  world.add_body(floor_body());
  std::vector<BodyId> boxes;
  for (int i = 0; i < 5; ++i) {
    const Real height = Real(0.5) + Real(i) - (i > 2 ? Real(0.3) : Real(0));
    boxes.push_back(
        world.add_body(body_at(box_shape({Real(0.5), Real(0.5), Real(0.5)}), {0, 0, height})));
  }
  EXPECT_LT(peak_speed(world, 60), 1);
  run(world, 240);
  EXPECT_LT(largest_speed(world), Real(0.01));
  EXPECT_NEAR(world.body(boxes.back()).pose.position.z(), 4.5, 0.01);
}

// The passes of a step with a push go through all contacts, but only those of bodies that part are treated otherwise.
TEST(Overlap, OtherBodiesMoveAsWithoutIt) {
  World alone;
  alone.add_body(floor_body());
  std::vector<BodyId> tower;
  for (int i = 0; i < 3; ++i) {
    tower.push_back(alone.add_body(body_at(unit_box(), {0, 0, Real(0.51) + Real(i)})));
  }
  run(alone, 60);
  World beside = alone;
  beside.add_body(body_at(unit_box(), {50, 0, 20}));
  beside.add_body(body_at(unit_box(), {50, 0, Real(20.7)}));
  run(alone, 10);
  run(beside, 10);
  for (const BodyId box : tower) {
    EXPECT_EQ(alone.body(box).linear_momentum, beside.body(box).linear_momentum);
    EXPECT_EQ(alone.body(box).pose.position, beside.body(box).pose.position);
  }
}

/// The impulse of the last substep on the floor below two boxes that overlap (N·s). The only pass of a substep relaxes,
/// so that nothing moves them apart.
Real impulse_on_floor(int steps, int substeps) {
  World world;
  world.settings().warm_starting = false;
  world.settings().pass_order = PassOrder::BackAndForth;
  world.settings().iterations = 0;
  world.settings().relax_iterations = 1;
  world.settings().substeps = substeps;
  world.add_body(floor_body());
  world.add_body(body_at(unit_box(), {0, 0, Real(0.5)}));
  world.add_body(body_at(unit_box(), {0, 0, 1}));
  for (int i = 0; i < steps; ++i) world.step(step_length / Real(steps));
  Real impulse = 0;
  for (const ContactPoint& point : world.contacts()[0].manifold.points) {
    impulse += point.normal_impulse;
  }
  return impulse;
}

// A step begins without impulses, and so must a substep. If it continues with those of the one before, it gives a
// third more.
TEST(Overlap, WithoutWarmStartingEachSubstepBeginsWithoutImpulses) {
  const Real begun_anew = impulse_on_floor(2, 1);
  EXPECT_GT(begun_anew, 0);
  EXPECT_NEAR(impulse_on_floor(1, 2), begun_anew, Real(0.02) * begun_anew);
}

}  // namespace
}  // namespace cs550
