// The energy and the momenta of a world.

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

constexpr Real substep_of_half_a_second = Real(0.5);  // s

/// A quarter turn: the body's x axis points along the world's y axis.
Quat quarter_turn() { return Quat(Eigen::AngleAxis<Real>(pi / 2, Vec3::UnitZ())); }

/// Two dynamic boxes, beside bodies that must not count.
World two_moving_boxes() {
  World world;
  world.settings().gravity = {1, -2, -10};
  BodyDef box = body_at(box_shape({Real(0.5), 1, Real(1.5)}), {1, 2, 3});  // 1 × 2 × 3 m
  box.mass = Real(2);
  box.pose.orientation = quarter_turn();
  box.linear_velocity = {4, 5, 6};
  box.angular_velocity = {0, 7, 0};
  world.add_body(box);
  BodyDef cube = body_at(unit_box(), {-40, 0, 8});
  cube.mass = Real(12);
  cube.linear_velocity = {-1, 2, 0};
  cube.angular_velocity = {0, 0, 3};
  world.add_body(cube);
  BodyDef lift = body_at(unit_box(), {30, 30, 30}, BodyKind::Kinematic);
  lift.linear_velocity = {100, 100, 100};
  lift.angular_velocity = {100, 100, 100};
  const BodyId lift_id = world.add_body(lift);
  const BodyId floor_id = world.add_body(body_at(unit_box(), {0, 0, -50}, BodyKind::Static));
  for (const BodyId id : {lift_id, floor_id}) {
    world.body(id).mass = 100;  // a program may write what it likes there
    world.body(id).linear_momentum = {100, 100, 100};
    world.body(id).angular_momentum = {100, 100, 100};
  }
  return world;
}

// About its own x axis, the world's y axis, the box has the inertia m·(2² + 3²)/12 = 13/6 kg·m², and the cube has
// m·(1² + 1²)/12 = 2 kg·m² about each axis. Floats have 24 bits.
constexpr double box_inertia = 13.0 / 6;
constexpr double cube_inertia = 2;
constexpr double float_rounding = 1e-6;

void expect_vector(const Eigen::Vector3d& got, const Eigen::Vector3d& expected) {
  EXPECT_LE((got - expected).norm(), float_rounding * expected.norm()) << got.transpose();
}

TEST(Momentum, OfTwoBoxesIsTheirSum) {
  const World world = two_moving_boxes();
  // 2·(4, 5, 6) + 12·(−1, 2, 0)
  expect_vector(linear_momentum(world), {-4, 34, 12});
  // x × P: (1, 2, 3) × (8, 10, 12) = (−6, 12, −6); (−40, 0, 8) × (−12, 24, 0) = (−192, −96, −960)
  expect_vector(angular_momentum(world),
                {-6 - 192, 12 - 96 + 7 * box_inertia, -6 - 960 + 3 * cube_inertia});
}

TEST(Energy, OfTwoBoxesIsTheirSum) {
  const World world = two_moving_boxes();
  const Energy sum = energy(world, substep_of_half_a_second);
  // ½·m·v² + ½·I·ω²
  const double box = 0.5 * 2 * (16 + 25 + 36) + 0.5 * box_inertia * 49;
  const double cube = 0.5 * 12 * (1 + 4) + 0.5 * cube_inertia * 9;
  EXPECT_NEAR(sum.kinetic, box + cube, float_rounding * (box + cube));
  // −m·g·x: −2·(1 − 4 − 30) − 12·(−40 + 0 − 80)
  EXPECT_NEAR(sum.potential, 66 + 1440, float_rounding * 1506);
  EXPECT_EQ(sum.total(), sum.kinetic + sum.potential);
  // ½·h·g·P: 0.25·(−4 − 68 − 120)
  EXPECT_NEAR(sum.invariant, sum.total() - 48, float_rounding * sum.total());
}

}  // namespace
}  // namespace cs550
