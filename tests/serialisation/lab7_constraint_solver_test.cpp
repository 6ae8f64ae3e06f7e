#include <gtest/gtest.h>

#include "cs550/constraint_solver.hpp"
#include "serialisation/contact_values.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

ContactStep some_step() {
  ContactStep step;
  step.h = 0.004F;
  step.backwards = true;
  step.soft = {20, 0.8F, 0.2F};
  step.soft_static = {40, 0.7F, 0.3F};
  step.slop = 0.001F;
  step.max_push_speed = 3;
  step.restitution_threshold = 0.5F;
  step.restitution_iterations = 3;
  return step;
}

TEST(Serialisation, Lab7IsCalledAcrossAWire) {
  const auto& [random, bodies, constraints] = BodiesInContact();
  const SolverBody& a = bodies[0];
  const SolverBody& b = bodies[1];
  const ContactConstraint& constraint = constraints[0];
  const ContactStep step = some_step();
  ContactStep relax = step;
  relax.use_bias = false;
  const ContactJacobian jacobian = contact_jacobian(constraint.n, constraint.r_a, constraint.r_b);

  EXPECT_SAME_ACROSS_WIRE(contact_jacobian, constraint.n, constraint.r_a, constraint.r_b);
  EXPECT_SAME_ACROSS_WIRE(constraint_mass, jacobian, a, b);
  EXPECT_SAME_ACROSS_WIRE(contact_bias, constraint, constraint.separation, step);
  EXPECT_SAME_ACROSS_WIRE(contact_bias, constraint, constraint.separation, relax);
  EXPECT_SAME_ACROSS_WIRE(prepare_contacts, constraints, bodies, step);
  EXPECT_SAME_ACROSS_WIRE(warm_start, constraint, a, b);
  EXPECT_SAME_ACROSS_WIRE(solve_normal, constraint, a, b, step);
  EXPECT_SAME_ACROSS_WIRE(solve_friction, constraint, a, b);
  EXPECT_SAME_ACROSS_WIRE(solve_contacts, constraints, bodies, step);
  EXPECT_SAME_ACROSS_WIRE(apply_restitution, constraints, bodies, step);
}

TEST(Serialisation, NoMemberOfLab7IsForgotten) {
  EXPECT_EVERY_WORD_SENT(ContactJacobian);
  EXPECT_EVERY_WORD_SENT(ContactStep);
  EXPECT_EVERY_WORD_SENT(ContactBias);
}

}  // namespace
}  // namespace cs550::test
