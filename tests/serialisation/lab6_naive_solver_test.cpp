#include <gtest/gtest.h>

#include "cs550/naive_solver.hpp"
#include "serialisation/contact_values.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

TEST(Serialisation, Lab6IsCalledAcrossAWire) {
  const auto& [random, bodies, constraints] = BodiesInContact();
  const SolverBody& a = bodies[0];
  const SolverBody& b = bodies[1];
  const ContactConstraint& constraint = constraints[0];
  EXPECT_SAME_ACROSS_WIRE(effective_mass, a, b, constraint.r_a, constraint.r_b, constraint.n);
  EXPECT_SAME_ACROSS_WIRE(normal_velocity, a, b, constraint.r_a, constraint.r_b, constraint.n);
  EXPECT_SAME_ACROSS_WIRE(resolve_contacts_naive, constraints, bodies);
}

TEST(Serialisation, NoMemberOfLab6IsForgotten) {
  EXPECT_EVERY_WORD_SENT(SolverBody);
  EXPECT_EVERY_WORD_SENT(Softness);
  EXPECT_EVERY_WORD_SENT(ContactConstraint);
}

}  // namespace
}  // namespace cs550::test
