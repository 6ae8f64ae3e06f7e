#include <gtest/gtest.h>

#include <vector>

#include "cs550/constraint_solver.hpp"

using namespace cs550;

SolverBody ball(const Vec3& v) {
  SolverBody body;
  body.inverse_mass = Real(0.5);
  body.world_inverse_inertia = Mat3::Identity();
  body.v = v;
  return body;
}

/// Ball 1 on ball 0, which cannot move.
class OnTheGround : public testing::Test {
 protected:
  OnTheGround() {
    contact.body_a = 0;
    contact.body_b = 1;
    contact.n = Vec3(0, 0, 1);
    contact.u = Vec3(1, 0, 0);
    contact.friction = Real(0.5);
    step.h = Real(0.01);
  }

  void prepare() {
    std::vector<ContactConstraint> contacts{contact};
    prepare_contacts(contacts, bodies, step);
    contact = contacts[0];
  }

  std::vector<SolverBody> bodies{SolverBody{}, ball(Vec3(1, 0, -4))};
  ContactConstraint contact;
  ContactStep step;
};

TEST(Jacobian, IsTheVelocityOfBRelativeToA) {
  const ContactJacobian row = contact_jacobian(Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0));
  EXPECT_FLOAT_EQ(row.linear_b.z(), 1);
  EXPECT_FLOAT_EQ(row.linear_a.z(), -1);
  EXPECT_FLOAT_EQ(row.angular_a.y(), 1);  // −(1, 0, 0) × (0, 0, 1)
  EXPECT_FLOAT_EQ(row.angular_b.x(), 1);  // (0, 1, 0) × (0, 0, 1)
}

TEST_F(OnTheGround, TheNormalImpulseStopsTheFall) {
  prepare();
  EXPECT_FLOAT_EQ(contact.normal_mass, 2);
  solve_normal(contact, bodies[0], bodies[1], step);
  EXPECT_NEAR(bodies[1].v.z(), 0, 1e-5);
  EXPECT_NEAR(contact.normal_impulse, 8, 1e-4);
}

TEST_F(OnTheGround, FrictionStaysInItsCone) {
  prepare();
  contact.normal_impulse = 1;
  solve_friction(contact, bodies[0], bodies[1]);
  EXPECT_NEAR(contact.tangent_impulse.norm(), 0.5, 1e-5);
  EXPECT_NEAR(bodies[1].v.x(), 1 - 0.5 * 0.5, 1e-5);
}

TEST_F(OnTheGround, WarmStartingAppliesTheImpulsesOfTheLastStep) {
  contact.normal_impulse = 2;
  contact.tangent_impulse = Vec2(Real(-0.5), 0);
  warm_start(contact, bodies[0], bodies[1]);
  EXPECT_FLOAT_EQ(bodies[1].v.z(), -3);
  EXPECT_FLOAT_EQ(bodies[1].v.x(), 0.75);
}
