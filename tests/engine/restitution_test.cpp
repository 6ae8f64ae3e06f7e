// Bounces of a whole world give no energy.

#include <gtest/gtest.h>

#include <algorithm>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// The most energy that a world has during a run over what it has now, as a factor.
double largest_energy(World& world, int steps) {
  const bool naive = world.settings().solver == SolverKind::Naive;
  const int substeps = naive ? 1 : world.settings().substeps;
  const Real h = step_length / static_cast<Real>(substeps);
  const double start = energy(world, h).invariant;
  double largest = start;
  for (int step = 0; step < steps; ++step) {
    world.step(step_length);
    largest = std::max(largest, energy(world, h).invariant);
  }
  return largest / start;
}

/// A box above a floor; with e = 1 it bounces for ever.
World bouncing_box(const Quat& orientation, Real restitution) {
  World world;
  world.settings().solver = SolverKind::Naive;
  world.add_body(floor_body());
  BodyDef box = body_at(box_shape({Real(0.5), Real(0.4), Real(0.3)}), {0, 0, 5});
  box.pose.orientation = orientation;
  box.friction = 0;
  box.restitution = restitution;
  world.add_body(box);
  return world;
}

/// Each impulse reflects what it finds, with the speed g·h that gravity has added in the step. At 60 steps
/// per second that was 1.6 % of the speed of a fall from 5 m, with each bounce.
TEST(WorldRestitution, TheNaiveSolverBouncesNoHigherThanBefore) {
  for (std::uint32_t seed = 1; seed <= 16; ++seed) {
    Random random(seed);
    World world = bouncing_box(random.orientation(), 1);
    EXPECT_LT(largest_energy(world, 600), 1.02) << "seed " << seed;
  }
}

/// Of a body that rests, gravity's g·h is the whole speed of approach. With e = 0.98 it hopped 7 cm high.
TEST(WorldRestitution, ABoxAtRestDoesNotBeginToHop) {
  World world = bouncing_box(Quat::Identity(), Real(0.98));
  const BodyId box = world.id_at(1);
  world.body(box).pose.position.z() = Real(0.3);
  for (int step = 0; step < 120; ++step) {
    world.step(step_length);
    EXPECT_NEAR(world.body(box).pose.position.z(), Real(0.3), Real(0.005)) << "step " << step;
  }
}

/// A plate of 1 : 22 that comes with its tip turns far within a substep of `game`. Its contact has then up to
/// twenty times the effective mass with which it met the floor, and other corners are in the way of its bounce.
/// Some of these plates gained two thirds. The push out of the floor may still give a few per cent: 4.6 at most,
/// over both compilers.
TEST(WorldRestitution, APlateThatTurnsInItsImpactKeepsItsEnergy) {
  const ShapePtr plate = box_shape({Real(0.44), Real(0.02), Real(0.1)});
  for (std::uint32_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    World world(game_settings());
    world.add_body(floor_body());
    BodyDef def = body_at(plate, {0, 0, Real(0.6)});
    def.pose.orientation = random.orientation();
    def.linear_velocity = {0, 0, random.real(-20, -2)};
    def.angular_velocity = random.real(0, 100) * random.unit_vector();
    def.friction = 0;
    def.restitution = 1;
    world.add_body(def);
    EXPECT_LT(largest_energy(world, 30), 1.1) << "seed " << seed;
  }
}

}  // namespace
}  // namespace cs550
