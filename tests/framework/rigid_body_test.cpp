#include "cs550/rigid_body.hpp"

#include <gtest/gtest.h>

#include "cs550/integration.hpp"

namespace cs550::test {
namespace {

const Pose pose{{1, 2, 3}, rotation_exp({0.4F, -0.8F, 1.2F})};

Mat3 skew_inertia() {
  Mat3 inertia;
  inertia << 3, 0.2F, -0.1F, 0.2F, 4, 0.3F, -0.1F, 0.3F, 5;
  return inertia;
}

TEST(RigidBody, DynamicBodyHasTheInversesAndRests) {
  const RigidBody body = make_dynamic_body(2, skew_inertia(), pose);
  EXPECT_EQ(body.inverse_mass, 0.5F);
  EXPECT_LE((body.inertia * body.inverse_inertia - Mat3::Identity()).norm(), 1e-6F);
  EXPECT_EQ(body.linear_momentum, Vec3::Zero());
  EXPECT_EQ(kinetic_energy(body), 0);
}

TEST(RigidBody, VelocitiesOfADynamicBodyComeBackFromItsMomenta) {
  RigidBody body = make_dynamic_body(2, skew_inertia(), pose);
  const Vec3 v(1, -2, 3), w(0.5F, 5, -0.5F);
  set_velocity(body, v, w);
  EXPECT_EQ(body.linear_momentum, 2 * v);
  refresh_velocity(body);
  EXPECT_LE((body.linear_velocity - v).norm(), 1e-6F);
  EXPECT_LE((body.angular_velocity - w).norm(), 1e-5F);
}

TEST(RigidBody, KineticEnergyOfATurningBox) {
  // About its own z-axis, rotated by the pose: ½·m·v² + ½·I_zz·w² = 9 + 10.
  RigidBody body = make_dynamic_body(2, Vec3(3, 4, 5).asDiagonal(), pose);
  set_velocity(body, {0, 3, 0}, pose.rotate({0, 0, 2}));
  EXPECT_NEAR(kinetic_energy(body), 19, 1e-5);
}

TEST(RigidBody, KinematicBodyMovesAndHasNoEnergy) {
  RigidBody body = make_immovable_body(BodyKind::Kinematic, pose);
  set_velocity(body, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(body.linear_velocity, Vec3(1, 0, 0));
  EXPECT_EQ(body.angular_velocity, Vec3(0, 1, 0));
  EXPECT_EQ(body.inverse_mass, 0);
  EXPECT_EQ(body.inverse_inertia, Mat3::Zero());
  EXPECT_EQ(kinetic_energy(body), 0);
}

TEST(RigidBody, StaticBodyTakesNoVelocity) {
  RigidBody body = make_immovable_body(BodyKind::Static, pose);
  set_velocity(body, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(body.linear_velocity, Vec3::Zero());
  EXPECT_EQ(body.angular_velocity, Vec3::Zero());
}

}  // namespace
}  // namespace cs550::test
