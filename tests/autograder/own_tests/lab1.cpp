#include <gtest/gtest.h>

#include "cs550/integration.hpp"

using namespace cs550;

/// 2 kg, with different moments of inertia about its axes, turned by 90° about z.
RigidBody turned_body() {
  const Vec3 moments(1, 2, 4);
  Pose pose;
  pose.orientation = rotation_exp(Vec3(0, 0, pi / 2));
  return make_dynamic_body(2, Mat3(moments.asDiagonal()), pose);
}

TEST(Forces, TurnTheBodyByLeverCrossForce) {
  RigidBody body = turned_body();
  add_force(body, Vec3(0, 3, 0), Vec3(2, 0, 0));
  add_force(body, Vec3(0, 1, 0), Vec3(0, 0, 0));
  EXPECT_FLOAT_EQ(body.force.y(), 4);
  EXPECT_FLOAT_EQ(body.torque.z(), 6);
}

TEST(Impulses, ChangeBothMomenta) {
  RigidBody body = turned_body();
  apply_impulse(body, Vec3(0, 0, 1), Vec3(0, 2, 0));
  EXPECT_FLOAT_EQ(body.linear_momentum.z(), 1);
  EXPECT_FLOAT_EQ(body.angular_momentum.x(), 2);
}

TEST(Inertia, TurnsWithTheBody) {
  const Mat3 inverse = world_inverse_inertia(turned_body());
  EXPECT_NEAR(inverse(0, 0), 0.5, 1e-6);
  EXPECT_NEAR(inverse(1, 1), 1, 1e-6);
  EXPECT_NEAR(inverse(2, 2), 0.25, 1e-6);
}

TEST(Step, MovesTheBodyByItsVelocity) {
  RigidBody body = turned_body();
  body.force = Vec3(4, 0, 0);
  integrate_momentum(body, Real(0.5));
  EXPECT_FLOAT_EQ(body.linear_momentum.x(), 2);
  refresh_velocity(body);
  EXPECT_FLOAT_EQ(body.linear_velocity.x(), 1);
  integrate_pose(body, Real(0.5), RotationMethod::Explicit);
  EXPECT_FLOAT_EQ(body.pose.position.x(), 0.5);
  EXPECT_NEAR(body.pose.orientation.norm(), 1, 1e-5);
}
