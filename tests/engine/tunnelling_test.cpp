// A body that moves by up to its smallest half extent in a substep does not pass through another.

#include <gtest/gtest.h>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// Checks that a small box shot at a wall of a given half thickness stays on its side.
void expect_stopped(Real wall_half_thickness, Real substep_travel, const Quat& orientation,
                    Real start) {
  WorldSettings settings;
  settings.gravity.setZero();
  World world(settings);
  const Vec3 half(Real(0.1), Real(0.2), Real(0.3));
  world.add_body(body_at(box_shape({wall_half_thickness, 5, 5}), Vec3::Zero(), BodyKind::Static));
  BodyDef shot = body_at(box_shape(half), {start, 0, 0});
  shot.pose.orientation = orientation;
  const Real substep = step_length / static_cast<Real>(settings.substeps);
  shot.linear_velocity = {substep_travel * half.x() / substep, 0, 0};
  const BodyId id = world.add_body(shot);
  for (int step = 0; step < 120; ++step) {
    world.step(step_length);
    ASSERT_LT(world.body(id).pose.position.x(), 0) << "step " << step;
  }
}

TEST(Tunnelling, NoneThroughAWall) {
  Random random(41);
  for (const Real travel : {Real(0.25), Real(0.5), Real(1)}) {
    for (int shot = 0; shot < 60; ++shot) {
      const Quat turned = random.orientation();
      const Quat orientation = shot == 0 ? Quat(Quat::Identity()) : turned;
      const Real start = random.real(-3, -2);
      SCOPED_TRACE(testing::Message()
                   << "seed 41, shot " << shot << ", " << travel << " half extents per substep");
      expect_stopped(Real(0.1), travel, orientation, start);
    }
  }
}

TEST(Tunnelling, NoneThroughAThinPlate) {
  Random random(42);
  for (int shot = 0; shot < 60; ++shot) {
    const Quat orientation = random.orientation();
    const Real start = random.real(-3, -2);
    SCOPED_TRACE(testing::Message() << "seed 42, shot " << shot);
    expect_stopped(Real(0.005), 1, orientation, start);
  }
}

TEST(Tunnelling, NoneThroughAPlateThatMovesTowardsTheShot) {
  Random random(43);
  WorldSettings settings;
  settings.gravity.setZero();
  const ShapePtr box = box_shape(Vec3::Constant(Real(0.1)));
  const ShapePtr plate = box_shape({Real(0.1), 5, 5});
  const Real substep = step_length / static_cast<Real>(settings.substeps);
  const Real speed = Real(0.5) * Real(0.1) / substep;  // each half a half extent per substep
  for (int shot = 0; shot < 100; ++shot) {
    SCOPED_TRACE(testing::Message() << "seed 43, shot " << shot);
    World world(settings);
    BodyDef left = body_at(box, {random.real(-3, -2), 0, 0});
    left.pose.orientation = random.orientation();
    left.linear_velocity = {speed, 0, 0};
    BodyDef right = body_at(plate, {random.real(2, 3), 0, 0});
    right.linear_velocity = {-speed, 0, 0};
    const BodyId a = world.add_body(left);
    const BodyId b = world.add_body(right);
    for (int step = 0; step < 60; ++step) {
      world.step(step_length);
      const Vec3 seen = world.body(b).pose.to_body(world.body(a).pose.position);
      ASSERT_LT(seen.x(), 0) << "step " << step << ": the box is behind the plate";
    }
  }
}

}  // namespace
}  // namespace cs550
