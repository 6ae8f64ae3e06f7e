// The energy of a contact's impulses, compared with what they do to bodies at rest.
#include <gtest/gtest.h>

#include <array>

#include "cs550/constraint_solver.hpp"
#include "engine/contacts/contact_constraints.hpp"
#include "engine/kernel_forms.hpp"

namespace cs550 {
namespace {

using namespace test;

double kinetic_energy(const SolverBody& body) {
  const Eigen::Vector3d v = body.v.cast<double>();
  const Eigen::Vector3d w = body.w.cast<double>();
  const Eigen::Matrix3d inertia = body.world_inverse_inertia.cast<double>().inverse();
  return (v.squaredNorm() / static_cast<double>(body.inverse_mass) + w.dot(inertia * w)) / 2;
}

/// What an impulse at a constraint gives to its bodies, if these are at rest (J).
double energy_given(std::array<SolverBody, 2> bodies, const ContactConstraint& constraint,
                    const Vec3& impulse) {
  bodies[0].apply(-impulse, constraint.r_a);
  bodies[1].apply(impulse, constraint.r_b);
  return kinetic_energy(bodies[0]) + kinetic_energy(bodies[1]);
}

SolverBody body_at_rest(Random& random, Real mass_scale, Real length) {
  SolverBody body = random_body(random, true);
  body.v.setZero();
  body.w.setZero();
  body.inverse_mass /= mass_scale;
  body.world_inverse_inertia /= mass_scale * length * length;
  return body;
}

/// For light and heavy bodies, small and large ones. The effective masses are floats: a thousandth
/// covers their rounding where the two tangents are nearly dependent.
TEST(ImpulseEnergy, IsTheKineticEnergyThatTheImpulsesGiveToBodiesAtRest) {
  Random random(1);
  WorldState world;
  const std::array<Index, 1> place{0};
  for (const Real mass : {Real(1e-12), Real(1e-6), Real(1), Real(1e6), Real(1e12)}) {
    for (const Real length : {Real(1e-3), Real(1), Real(1e3)}) {
      SCOPED_TRACE(testing::Message() << mass << " kg, " << length << " m");
      for (int i = 0; i < 200; ++i) {
        const std::array<SolverBody, 2> bodies{body_at_rest(random, mass, length),
                                               body_at_rest(random, mass, length)};
        ContactConstraint constraint;
        constraint.body_a = 0;
        constraint.body_b = 1;
        constraint.n = random.unit_vector();
        constraint.u = constraint.n.unitOrthogonal();
        constraint.r_a = random.real(Real(0.2), 1) * length * random.unit_vector();
        constraint.r_b = random.real(Real(0.2), 1) * length * random.unit_vector();
        prepare_contacts({&constraint, 1}, bodies, ContactStep{});
        constraint.normal_impulse = random.real(0, 2) * mass;
        constraint.tangent_impulse = {random.real(-1, 1) * mass, random.real(-1, 1) * mass};
        world.constraints.assign(1, constraint);
        const Vec3 normal = constraint.normal_impulse * constraint.n;
        const Vec3 tangential = constraint.tangent_impulse.x() * constraint.u +
                                constraint.tangent_impulse.y() * constraint.v();
        const double given =
            energy_given(bodies, constraint, normal) + energy_given(bodies, constraint, tangential);
        ASSERT_NEAR(impulse_energy(world, place), given, 1e-3 * given);
      }
    }
  }
}

TEST(ImpulseEnergy, IsZeroWithoutMass) {
  WorldState world;
  world.constraints.resize(1);
  world.constraints[0].normal_impulse = 1;
  world.constraints[0].tangent_impulse = {1, 1};
  const std::array<Index, 1> place{0};
  EXPECT_EQ(impulse_energy(world, place), 0);
}

}  // namespace
}  // namespace cs550
