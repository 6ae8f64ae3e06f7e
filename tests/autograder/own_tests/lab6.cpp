#include <gtest/gtest.h>

#include <vector>

#include "cs550/naive_solver.hpp"

using namespace cs550;

SolverBody ball(Real mass, const Vec3& v) {
  SolverBody body;
  body.inverse_mass = 1 / mass;
  body.world_inverse_inertia = Mat3::Identity();
  body.v = v;
  return body;
}

TEST(EffectiveMass, CombinesMassesAndLevers) {
  const Vec3 x(1, 0, 0);
  const Vec3 none(0, 0, 0);
  EXPECT_FLOAT_EQ(effective_mass(ball(2, none), ball(2, none), none, none, x), 1);
  // 1/m = 1/2 + 1/2 + |(0, 1, 0) × x|²
  EXPECT_FLOAT_EQ(effective_mass(ball(2, none), ball(2, none), Vec3(0, 1, 0), none, x), 0.5);
}

TEST(NormalVelocity, IsNegativeWhenApproaching) {
  const Vec3 none(0, 0, 0);
  EXPECT_FLOAT_EQ(
      normal_velocity(ball(1, Vec3(2, 0, 0)), ball(1, Vec3(-1, 0, 0)), none, none, Vec3(1, 0, 0)),
      -3);
}

TEST(Collision, OfEqualBallsExchangesTheirVelocities) {
  for (const Real restitution : {Real(0), Real(1)}) {
    std::vector<SolverBody> bodies{ball(1, Vec3(2, 0, 0)), ball(1, Vec3(0, 0, 0))};
    ContactConstraint contact;
    contact.body_a = 0;
    contact.body_b = 1;
    contact.n = Vec3(1, 0, 0);
    contact.restitution = restitution;
    std::vector<ContactConstraint> contacts{contact};
    resolve_contacts_naive(contacts, bodies);
    EXPECT_FLOAT_EQ(bodies[0].v.x(), 1 - restitution);
    EXPECT_FLOAT_EQ(bodies[1].v.x(), 1 + restitution);
    EXPECT_FLOAT_EQ(contacts[0].normal_impulse, 1 + restitution);
  }
}
