// A pass over many constraints: the engine's kernel must give the same bits as solving one
// constraint after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "cs550/constraint_solver.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

struct System {
  std::vector<SolverBody> bodies;
  std::vector<ContactConstraint> constraints;
};

SolverBody random_body(Random& random, bool movable) {
  SolverBody body;
  body.v = random.real(0, 2) * random.unit_vector();
  body.w = random.real(0, 3) * random.unit_vector();
  if (movable) {
    const Mat3 turn = random.orientation().toRotationMatrix();
    const Vec3 inertia(random.real(1, 3), random.real(2, 5), random.real(3, 6));
    body.inverse_mass = random.real(Real(0.1), 2);
    body.world_inverse_inertia = turn * inertia.asDiagonal() * turn.transpose();
    body.delta_position = random.real(0, Real(0.05)) * random.unit_vector();
    body.delta_rotation = random.real(0, Real(0.05)) * random.unit_vector();
  }
  return body;
}

/// All kinds of constraints: separated and penetrating, with and without load, rough and smooth.
ContactConstraint random_constraint(Random& random, Index a, Index b) {
  ContactConstraint constraint;
  constraint.body_a = a;
  constraint.body_b = b;
  constraint.n = random.unit_vector();
  constraint.u = constraint.n.unitOrthogonal();
  constraint.r_a = random.real(Real(0.2), 1) * random.unit_vector();
  constraint.r_b = random.real(Real(0.2), 1) * random.unit_vector();
  constraint.separation = random.real(Real(-0.05), Real(0.02));
  constraint.friction = random.real(0, 1) < Real(0.2) ? 0 : random.real(0, 2);
  constraint.restitution = random.real(0, 1) < Real(0.5) ? 0 : random.real(0, 1);
  constraint.approach_velocity = random.real(-3, 1);
  constraint.impact_handled = random.real(0, 1) < Real(0.5);
  if (random.real(0, 1) < Real(0.7)) {
    constraint.normal_impulse = random.real(0, 2);
    constraint.tangent_impulse = {random.real(-1, 1), random.real(-1, 1)};
  }
  return constraint;
}

/// Random bodies, the last fifth of them immovable, and constraints between pairs with at least one
/// movable body.
System random_system(Random& random, const ContactStep& step) {
  System system;
  const Index bodies = random.integer(2, 40);
  const Index movable = std::max(Index(1), bodies * 4 / 5);
  for (Index i = 0; i < bodies; ++i) system.bodies.push_back(random_body(random, i < movable));
  for (Index i = random.integer(0, 100); i > 0; --i) {
    const Index a = random.integer(0, movable - 1);
    const Index b = random.integer(0, bodies - 1);
    if (a != b) system.constraints.push_back(random_constraint(random, a, b));
  }
  prepare_contacts(system.constraints, system.bodies, step);
  return system;
}

/// L7.8 as its contract specifies it, with the functions of L7.6 and L7.7.
void solve_one_by_one(System& system, const ContactStep& step) {
  const std::size_t count = system.constraints.size();
  for (std::size_t i = 0; i < count; ++i) {
    ContactConstraint& constraint = system.constraints[step.backwards ? count - 1 - i : i];
    SolverBody& a = system.bodies[constraint.body_a];
    SolverBody& b = system.bodies[constraint.body_b];
    if (step.backwards) solve_friction(constraint, a, b);
    solve_normal(constraint, a, b, step);
    if (!step.backwards) solve_friction(constraint, a, b);
  }
}

bool same_bits(Real x, Real y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

template <class Vector>
bool same_bits(const Vector& x, const Vector& y) {
  return std::equal(x.begin(), x.end(), y.begin(), [](Real a, Real b) { return same_bits(a, b); });
}

ContactStep step_of(ContactModel model, bool use_bias, bool backwards) {
  ContactStep step;
  step.h = Real(1) / 240;
  step.model = model;
  step.use_bias = use_bias;
  step.backwards = backwards;
  step.soft = soft_contact(30, 4, step.h);
  step.soft_static = soft_contact(60, 2, step.h);
  step.slop = Real(0.005);
  step.max_push_speed = 3;
  step.restitution_threshold = 1;
  return step;
}

TEST(Passes, LeaveTheBitsOfOneConstraintAfterTheOther) {
  int slides = 0;
  int presses = 0;
  for (const ContactModel model : {ContactModel::Soft, ContactModel::Baumgarte}) {
    for (const bool use_bias : {true, false}) {
      for (const bool backwards : {true, false}) {
        const ContactStep step = step_of(model, use_bias, backwards);
        for (std::uint32_t seed = 1; seed <= 50; ++seed) {
          SCOPED_TRACE("seed " + std::to_string(seed));
          Random random(seed);
          System at_once = random_system(random, step);
          System in_turn = at_once;
          solve_contacts(at_once.constraints, at_once.bodies, step);
          solve_one_by_one(in_turn, step);
          for (std::size_t i = 0; i < in_turn.constraints.size(); ++i) {
            const ContactConstraint& constraint = at_once.constraints[i];
            const ContactConstraint& expected = in_turn.constraints[i];
            ASSERT_TRUE(same_bits(constraint.normal_impulse, expected.normal_impulse))
                << "constraint " << i;
            ASSERT_TRUE(same_bits(constraint.tangent_impulse, expected.tangent_impulse))
                << "constraint " << i;
            ASSERT_EQ(constraint.impact_handled, expected.impact_handled) << "constraint " << i;
            const Real limit = constraint.friction * constraint.normal_impulse;
            if (limit > 0 && constraint.tangent_impulse.norm() > Real(0.999) * limit) ++slides;
            if (constraint.normal_impulse > 0) ++presses;
          }
          for (std::size_t i = 0; i < in_turn.bodies.size(); ++i) {
            ASSERT_TRUE(same_bits(at_once.bodies[i].v, in_turn.bodies[i].v)) << "body " << i;
            ASSERT_TRUE(same_bits(at_once.bodies[i].w, in_turn.bodies[i].w)) << "body " << i;
          }
        }
      }
    }
  }
  EXPECT_GT(slides, 1000) << "the systems no longer try contacts that slide";
  EXPECT_GT(presses - slides, 1000) << "the systems no longer try contacts that stick";
}

}  // namespace
}  // namespace cs550::test
