// Rolling resistance, compared with closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr double gravity = 9.81;
constexpr Real edge = 1;  // of the cube (m)
constexpr Real spin = 2;  // rad/s

/// A cube that spins about its vertical axis on a floor without friction: rolling resistance is all
/// that can slow it.
World spinning_cube(Real rolling_resistance, Real length_unit = 1) {
  WorldSettings settings;
  settings.rolling_resistance = rolling_resistance;
  settings.length_unit = length_unit;
  World world(settings);
  BodyDef floor = floor_body();
  floor.friction = 0;
  world.add_body(floor);
  BodyDef cube = body_at(box_shape(Vec3::Constant(edge / 2)), {0, 0, edge / 2});
  cube.angular_velocity = {0, 0, spin};
  world.add_body(cube);
  return world;
}

double spin_of(const World& world) { return world.bodies()[1].angular_velocity.z(); }

/// The torque ρ·m·g on the moment of inertia m·a²/6.
double deceleration(double lever) { return lever * gravity * 6 / (edge * edge); }

TEST(RollingResistance, SlowsASpinningCubeByItsLeverTimesTheWeight) {
  for (const Real lever : {Real(0), Real(0.005), Real(0.02)}) {
    World world = spinning_cube(lever);
    run(world, 60);
    EXPECT_NEAR(spin_of(world), spin - deceleration(lever), 0.01) << "lever " << lever << " m";
  }
}

TEST(RollingResistance, IsALeverInLengthUnits) {
  World world = spinning_cube(Real(0.002), 10);
  run(world, 60);
  EXPECT_NEAR(spin_of(world), spin - deceleration(0.02), 0.01);
}

TEST(RollingResistance, StopsARotationAndNeverReversesIt) {
  World world = spinning_cube(Real(0.02));
  const int stop = static_cast<int>(std::ceil(60 * spin / deceleration(0.02)));
  for (int step = 0; step < 2 * stop; ++step) {
    world.step(step_length);
    EXPECT_GT(spin_of(world), -1e-4) << "step " << step;
  }
  EXPECT_NEAR(spin_of(world), 0, 1e-4);
}

TEST(RollingResistance, TakesNoEnergyFromAFreeBody) {
  World without = spinning_cube(0);
  World with = spinning_cube(Real(0.1));
  for (World* world : {&without, &with}) {
    world->settings().gravity.setZero();
    world->body(world->id_at(1)).pose.position.z() = 5;
    run(*world, 60);
  }
  EXPECT_EQ(without.state_hash(), with.state_hash());
}

struct Tilt {
  double after_two_seconds, after_six_seconds;  // rad
};

/// Of a cube on a table, with its centre of mass 2 mm beyond the edge.
Tilt tilt_of_overhanging_cube(Real rolling_resistance) {
  WorldSettings settings = game_settings();
  settings.rolling_resistance = rolling_resistance;
  World world(settings);
  BodyDef table = body_at(box_shape({1, 1, Real(0.5)}), {0, 0, Real(-0.5)});
  table.kind = BodyKind::Static;
  world.add_body(table);
  world.add_body(body_at(box_shape(Vec3::Constant(edge / 2)), {Real(1.002), 0, edge / 2}));
  const auto tilt_after = [&](int steps) -> double {
    run(world, steps);
    return std::abs(world.bodies()[1].pose.orientation.angularDistance(Quat::Identity()));
  };
  const double after_two_seconds = tilt_after(120);
  return {after_two_seconds, tilt_after(240)};
}

/// The torque of gravity is the overhang times the weight. The cube is put down at once, so its springs
/// yield twice as far as under a load that grows slowly: the lever must be more than twice the overhang.
TEST(RollingResistance, BalancesATorqueWithoutCreep) {
  EXPECT_GT(tilt_of_overhanging_cube(0).after_two_seconds, 0.1) << "nothing holds the cube";
  EXPECT_GT(tilt_of_overhanging_cube(Real(0.001)).after_two_seconds, 0.1)
      << "a lever shorter than the overhang";
  const Tilt held = tilt_of_overhanging_cube(Real(0.005));
  EXPECT_LT(held.after_two_seconds, 1e-3) << "the springs yield by less than a millimetre";
  // Turning by τh²/I in each substep would be 8e-4 rad in four seconds.
  EXPECT_NEAR(held.after_six_seconds, held.after_two_seconds, 1e-5);
}

}  // namespace
}  // namespace cs550
