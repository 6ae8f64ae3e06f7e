// Bounces of a whole world give no energy.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

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

/// Three equal cubes in a row on ice, e = 1. The first moves at 2 m/s towards the other two, which touch.
/// @param distance the gap in front of the first cube (m)
/// @param reversed whether the cubes are added from the last to the first
/// @returns velocities along the row after half a second (m/s)
std::array<Real, 3> after_blow(const WorldSettings& settings, Real distance, bool reversed) {
  World world(settings);
  world.add_body(floor_body());
  std::array<BodyId, 3> ids;
  for (int i = 0; i < 3; ++i) {
    const int place = reversed ? 2 - i : i;
    BodyDef cube =
        body_at(box_shape(Vec3::Constant(Real(0.5))), {static_cast<Real>(place), 0, Real(0.5)});
    cube.friction = 0;
    cube.restitution = 1;
    if (place == 0) {
      cube.pose.position.x() = -distance;
      cube.linear_velocity.x() = 2;
    }
    ids[place] = world.add_body(cube);
  }
  for (int step = 0; step < 30; ++step) world.step(step_length);
  std::array<Real, 3> velocities{};
  for (int i = 0; i < 3; ++i) velocities[i] = world.body(ids[i]).linear_velocity.x();
  return velocities;
}

/// Bodies that touch are hit as one: with −2/3, 4/3 and 4/3 m/s momentum is kept, the first two part at 2 m/s
/// and the others stay together. That takes an impulse on the last cube before anything bounces, and a single
/// pass against the order of the row gives none.
TEST(WorldRestitution, ABlowReachesTheWholeRowInEitherOrder) {
  const Real tolerance = Real(0.04);  // the sweeps of apply_restitution() end before they converge
  for (const WorldSettings& settings : {accurate_settings(), game_settings()}) {
    for (int i = 0; i < 40; ++i) {
      const Real distance = Real(0.2) + Real(0.004) * static_cast<Real>(i);
      const auto velocities = after_blow(settings, distance, i % 2 == 1);
      SCOPED_TRACE("start " + std::to_string(i) + ", " + std::to_string(settings.substeps) +
                   " substeps");
      EXPECT_NEAR(velocities[0], Real(-2) / 3, tolerance);
      EXPECT_NEAR(velocities[1], Real(4) / 3, tolerance);
      EXPECT_NEAR(velocities[2], Real(4) / 3, tolerance);
    }
  }
}

}  // namespace
}  // namespace cs550
