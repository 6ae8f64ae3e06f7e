#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"

namespace cs550::test {
namespace {

/// A few roundings of a sum of twelve products, relative to its largest terms.
constexpr double jacobian_rounding = 2e-6;

GRADED_TEST(Lab7, JacobianIsTheRateOfTheRelativePosition, 2, "L7.1") {
  Random random(7101);
  Story story("J·V is d·(v_B + ω_B × r_B − v_A − ω_A × r_A) for every V");
  story.seed(random.seed())
      .likely("r × d and d × r differ in sign: d·(ω × r) = ω·(r × d)")
      .likely("A's two terms are negative, B's positive: the normal points from A to B");
  for (int i = 0; i < 200; ++i) {
    const ContactConstraint constraint = random_constraint(random);
    const ContactJacobian j = contact_jacobian(constraint.n, constraint.r_a, constraint.r_b);
    const Vec12 expected = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b);
    Story contact = story;
    contact.given("direction", Story::show(constraint.n)).given("r_a", Story::show(constraint.r_a));
    contact.given("r_b", Story::show(constraint.r_b));
    require(contact.expect_near("part of v_A", j.linear_a, expected.segment<3>(0).cast<Real>(),
                                jacobian_rounding));
    require(contact.expect_near("part of ω_A", j.angular_a, expected.segment<3>(3).cast<Real>(),
                                jacobian_rounding));
    require(contact.expect_near("part of v_B", j.linear_b, expected.segment<3>(6).cast<Real>(),
                                jacobian_rounding));
    require(contact.expect_near("part of ω_B", j.angular_b, expected.segment<3>(9).cast<Real>(),
                                jacobian_rounding));
  }
}

GRADED_TEST(Lab7, ConstraintMassMatchesDenseAlgebra, 2, "L7.2") {
  Random random(7102);
  Story story("the constraint mass is 1/(J·M⁻¹·Jᵀ)");
  story.seed(random.seed())
      .likely("the world inverse inertia belongs between the two angular parts of J")
      .likely("the sum has four terms: two of each body")
      .likely("the mass is 0 only if the sum is 0: heavy bodies have a small one");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    Story of_size = story;
    of_size.given("size", size, "m");
    for (int i = 0; i < 200; ++i) {
      const SolverBody a = random_body(random, size);
      const SolverBody b = i % 4 == 0 ? immovable_body() : random_body(random, size);
      const ContactConstraint constraint = random_constraint(random, size);
      const Vec12 j = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b);
      const double expected = 1 / j.dot(dense_inverse_mass(a, b) * j);
      ContactJacobian given;
      given.linear_a = j.segment<3>(0).cast<Real>();
      given.angular_a = j.segment<3>(3).cast<Real>();
      given.linear_b = j.segment<3>(6).cast<Real>();
      given.angular_b = j.segment<3>(9).cast<Real>();
      const double got = static_cast<double>(constraint_mass(given, a, b));
      require(of_size.expect_near("constraint mass", got, expected,
                                  10 * jacobian_rounding * expected, "kg"));
    }
  }
}

GRADED_TEST(Lab7, TwoImmovableBodiesHaveNoConstraintMass, 1, "L7.2") {
  Story story("an impulse between two immovable bodies does nothing, so its mass is set to 0");
  story.likely("1/0 is infinite, and 0·∞ later becomes NaN");
  const ContactJacobian j{-Vec3::UnitZ(), Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero()};
  SolverBody movable;
  movable.inverse_mass = Real(0.5);
  Story wall = story;
  wall.given("a body of 2 kg against an immovable one");
  require(wall.expect_near("constraint mass",
                           static_cast<double>(constraint_mass(j, immovable_body(), movable)), 2,
                           1e-6, "kg"));
  const Real mass = constraint_mass(j, immovable_body(), immovable_body());
  story.expect_near("constraint mass", static_cast<double>(mass), 0, 0, "kg");
}

GRADED_TEST(Lab7, PreparedMassesInvertTheCoupledTangents, 3, "L7.4") {
  Random random(7103);
  Story story("normal_mass is 1/(J_n·M⁻¹·J_nᵀ), tangent_mass the inverse of the 2 × 2 of u and v");
  story.seed(random.seed())
      .likely(
          "u and v are coupled through the rotation: the matrix has numbers beside its diagonal")
      .likely("inverting the diagonal alone gives two separate masses")
      .likely("only a determinant that is not positive gives 0: that of heavy bodies is small");
  Story with_swapped_diagonal("tangent_mass is the inverse of the 2 × 2 matrix of u and v");
  with_swapped_diagonal.seed(random.seed())
      .likely("the inverse of a 2 × 2 matrix swaps its diagonal: k_vv is the first, k_uu the last");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (int i = 0; i < 100; ++i) {
      std::vector<SolverBody> bodies = {random_body(random, size), random_body(random, size)};
      if (i % 4 == 0) bodies[0] = immovable_body();
      std::vector<ContactConstraint> constraints = {random_constraint(random, size)};
      prepare_contacts(constraints, bodies, rigid_step());
      const ContactConstraint& constraint = constraints[0];
      Story prepared = story;
      prepared.given("size", size, "m");

      const Eigen::Matrix3d k = dense_inverse_contact_mass(constraint, bodies[0], bodies[1]);
      const double expected = 1 / k(0, 0);
      require(prepared.expect_near("normal mass", static_cast<double>(constraint.normal_mass),
                                   expected, 10 * jacobian_rounding * expected, "kg"));
      // The mass times the matrix that it inverts: rounding grows with the condition number.
      const Eigen::Matrix2d tangents = k.bottomRightCorner<2, 2>();
      const auto error_of = [&](const Eigen::Matrix2d& mass) {
        return (mass * tangents - Eigen::Matrix2d::Identity()).norm();
      };
      const double condition = tangents.trace() * tangents.trace() / tangents.determinant();
      const double tolerance = jacobian_rounding * condition;
      const Eigen::Matrix2d mass = constraint.tangent_mass.cast<double>();
      Eigen::Matrix2d swapped = mass;
      std::swap(swapped(0, 0), swapped(1, 1));
      Story here = error_of(swapped) <= tolerance ? with_swapped_diagonal : story;
      here.given("size", size, "m");
      require(here.expect_near("distance of tangent_mass · (J·M⁻¹·Jᵀ) from the identity",
                               error_of(mass), 0, tolerance));
    }
  }
}

GRADED_TEST(Lab7, ContactsWithAnImmovableBodyAreStiffer, 1, "L7.4") {
  Random random(7104);
  ContactStep step = rigid_step();
  step.soft = {10, Real(0.7), Real(0.3)};
  step.soft_static = {20, Real(0.6), Real(0.4)};
  std::vector<SolverBody> bodies = {random_body(random), random_body(random), immovable_body(),
                                    immovable_body()};
  std::vector<ContactConstraint> constraints(4, random_constraint(random));
  constraints[1].body_b = 2;
  constraints[2].body_a = 2;
  constraints[2].body_b = 0;
  constraints[3].body_a = 2;
  constraints[3].body_b = 3;
  prepare_contacts(constraints, bodies, step);
  Story story(
      "a constraint uses soft between movable bodies and soft_static where either is immovable");
  story.likely("the immovable body may be A or B")
      .likely("a softness has three members, and the constraint needs all of them");
  const auto expect_softness = [&](const char* which, const Softness& got, const Softness& wanted) {
    Story here = story;
    here.given(which);
    here.expect_equal("bias rate", got.bias_rate, wanted.bias_rate);
    here.expect_equal("mass scale", got.mass_scale, wanted.mass_scale);
    here.expect_equal("impulse scale", got.impulse_scale, wanted.impulse_scale);
  };
  expect_softness("both movable", constraints[0].softness, step.soft);
  expect_softness("B immovable", constraints[1].softness, step.soft_static);
  expect_softness("A immovable", constraints[2].softness, step.soft_static);
  Story walls("between two immovable bodies both masses are zero");
  walls.likely("no impulse moves two immovable bodies: the tangents' matrix has no inverse");
  walls.expect_near("normal mass", static_cast<double>(constraints[3].normal_mass), 0, 0);
  walls.expect_near("largest entry of the tangents' mass",
                    static_cast<double>(constraints[3].tangent_mass.cwiseAbs().maxCoeff()), 0, 0);
}

}  // namespace
}  // namespace cs550::test
