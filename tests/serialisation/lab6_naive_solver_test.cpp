#include <gtest/gtest.h>

#include "cs550/naive_solver.hpp"
#include "serialisation/contact_values.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

TEST(Serialisation, Lab6IsCalledAcrossAWire) {
  const auto& [random, bodies, rows] = BodiesInContact();
  const BodyVelocity& a = bodies[0];
  const BodyVelocity& b = bodies[1];
  const ContactRow& row = rows[0];
  EXPECT_SAME_ACROSS_WIRE(effective_mass, a, b, row.r_a, row.r_b, row.n);
  EXPECT_SAME_ACROSS_WIRE(normal_velocity, a, b, row.r_a, row.r_b, row.n);
  EXPECT_SAME_ACROSS_WIRE(resolve_contacts_naive, rows, bodies);
}

TEST(Serialisation, NoMemberOfLab6IsForgotten) {
  EXPECT_EVERY_WORD_SENT(BodyVelocity);
  EXPECT_EVERY_WORD_SENT(Softness);
  EXPECT_EVERY_WORD_SENT(ContactRow);
}

}  // namespace
}  // namespace cs550::test
