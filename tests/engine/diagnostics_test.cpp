// The energy of a world.

#include "cs550/diagnostics.hpp"

#include <gtest/gtest.h>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

TEST(Energy, FreeFallKeepsTheInvariantWhileEachStepLosesAKnownEnergy) {
  WorldSettings settings;
  settings.substeps = 1;
  World world(settings);
  BodyDef ball = body_at(box_shape(Vec3::Constant(Real(0.5))), Vec3::Zero());
  ball.mass = 1;
  ball.linear_velocity = {1, 0, 5};
  world.add_body(ball);

  constexpr int steps = 120;
  const Energy before = energy(world, step_length);
  run(world, steps);
  const Energy after = energy(world, step_length);
  constexpr double g = 9.81, h = 1 / 60.0;
  // Rounding of float: 240 sums of numbers near 10, times m·g.
  EXPECT_NEAR(after.invariant, before.invariant, 0.02);
  EXPECT_NEAR(before.total() - after.total(), steps * 0.5 * g * g * h * h, 0.02);
}

}  // namespace
}  // namespace cs550
