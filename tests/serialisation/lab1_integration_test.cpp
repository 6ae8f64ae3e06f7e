#include <gtest/gtest.h>

#include "cs550/integration.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

RigidBody spinning_body() {
  RigidBody body = make_dynamic_body(2, Vec3(3, 4, 5).asDiagonal(),
                                     {{1, 2, 3}, rotation_exp({0.1F, -0.2F, 0.3F})});
  set_velocity(body, {1, 2, 3}, {0.5F, 5, 0.5F});
  refresh_velocity(body);
  body.force = {7, 8, 9};
  body.torque = {-1, -2, -3};
  return body;
}

TEST(Serialisation, Lab1IsCalledAcrossAWire) {
  const RigidBody body = spinning_body();
  EXPECT_SAME_ACROSS_WIRE(add_force, body, {1, 2, 3}, {4, 5, 6});
  EXPECT_SAME_ACROSS_WIRE(apply_impulse, body, {1, 2, 3}, {4, 5, 6});
  EXPECT_SAME_ACROSS_WIRE(world_inverse_inertia, body);
  EXPECT_SAME_ACROSS_WIRE(refresh_velocity, body);
  EXPECT_SAME_ACROSS_WIRE(integrate_momentum, body, 0.01F);
  EXPECT_SAME_ACROSS_WIRE(integrate_pose, body, 0.01F, RotationMethod::ImplicitMidpoint);
}

TEST(Serialisation, NoMemberOfLab1IsForgotten) {
  EXPECT_EVERY_WORD_SENT(Pose);
  EXPECT_EVERY_WORD_SENT(RigidBody);
}

}  // namespace
}  // namespace cs550::test
