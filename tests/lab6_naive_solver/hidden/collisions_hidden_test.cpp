// Other shapes, orders and seeds for the properties of lab 6.
#include <cs550/graded_test.hpp>

#include "helpers/story.hpp"
#include "lab6_naive_solver/collision.hpp"
#include "lab6_naive_solver/stack.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab6, EffectiveMassOfNeedlesAndPlates, 3, "L6.1") {
  Random random(601);
  for (const Vec3& shape : {Vec3(1, Real(0.02), Real(0.02)), Vec3(1, 1, Real(0.01))}) {
    for (const Real size : {Real(0.02), Real(50)}) {
      const SolverBody a = movable(random.real(1, 5), size * shape, random.orientation());
      const SolverBody b = movable(1000, size * shape, random.orientation());
      const Vec3 r_a = size * random.unit_vector();
      const Vec3 r_b = size * random.unit_vector();
      const Vec3 d = random.unit_vector();
      const double exact = dense_effective_mass(a, b, r_a, r_b, d);
      Story story("m_e = 1/(J·M⁻¹·Jᵀ), for thin bodies and great ratios of mass");
      story.seed(random.seed()).given("half-extents", Vec3(size * shape), "m");
      story.likely("the bracket: d·[(W(r × d)) × r], the cross product with r comes last");
      // The inertia of a needle varies by a factor of 1000 with direction: that many roundings more.
      story.expect_near("m_e", effective_mass(a, b, r_a, r_b, d), exact, 6e-5 * exact, "kg");
    }
  }
}

GRADED_TEST(Lab6, SpinningBodyStrikesAWall, 3, "L6.4") {
  Random random(602);
  for (const Real size : {Real(0.05), Real(1), Real(20)}) {
    Collision at = random_collision(random, size, Real(0.3));
    at.a.inverse_mass = 0;
    at.a.world_inverse_inertia = Mat3::Zero();
    at.a.v = Vec3::Zero();
    at.a.w = Vec3::Zero();
    const double inverse_mass = at.b.inverse_mass;
    const double before = dense_jacobian(at.constraint.n, at.constraint.r_a, at.constraint.r_b)
                              .dot(dense_velocity(at.a, at.b));
    if (before > 0) at.constraint.n = -at.constraint.n;
    const Vec3 along = at.constraint.n.cross(at.b.v);
    const Vec3 v = at.b.v;
    Story story("A spinning box leaves a wall at e times the speed of its corner");
    story.seed(random.seed()).given("size", size, "m").given("e", 0.3);
    story.likely("a point at r of a turning body moves by ω × r as well, in that order")
        .likely("j = −(1 + e)·v_n·m_e: 1 stops the approach, e throws back");
    collide(at);
    const double after = dense_jacobian(at.constraint.n, at.constraint.r_a, at.constraint.r_b)
                             .dot(dense_velocity(at.a, at.b));
    story.expect_near("v_n afterwards", after, 0.3 * std::abs(before), 2e-5 * size, "m/s");
    const double exchanged = (at.b.v - v).norm() / inverse_mass;
    story.expect_near("impulse", at.constraint.normal_impulse, exchanged, 1e-4 * exchanged, "N·s");
    story.expect_near("velocity along the wall, n × v", at.constraint.n.cross(at.b.v), along,
                      1e-5 * size, "m/s");
    story.expect_near("v of the wall", at.a.v, Vec3::Zero(), 0, "m/s");
  }
}

GRADED_TEST(Lab6, BlowsPassOnInTheOrderOfTheConstraints, 3, "L6.4") {
  const Vec3 x = Vec3::UnitX();
  const auto run = [&x](Real e, bool forwards) {
    std::vector<SolverBody> bodies(3, movable(1, Vec3(1, 1, 1)));
    bodies[0].v = Vec3(3, 0, 0);
    std::vector<ContactConstraint> constraints = {touching(x, x, -x, e, 0, 1),
                                                  touching(x, x, -x, e, 1, 2)};
    if (!forwards) std::swap(constraints[0], constraints[1]);
    resolve_contacts_naive(constraints, bodies);
    return Vec3(bodies[0].v.x(), bodies[1].v.x(), bodies[2].v.x());
  };
  Story story("Each constraint sees what the constraints before it did, so their order decides");
  story.given("three touching bodies of 1 kg, the first at 3 m/s");
  story.likely("constraints are visited once, in order, with the velocities of that moment");
  story.expect_near("e = 1, contacts in the order of the blow", run(1, true), Vec3(0, 0, 3), 1e-6,
                    "m/s");
  story.expect_near("e = 1, the far contact first", run(1, false), Vec3(0, 3, 0), 1e-6, "m/s");
  story.expect_near("e = 0, contacts in the order of the blow", run(0, true),
                    Vec3(Real(1.5), Real(0.75), Real(0.75)), 1e-6, "m/s");
  story.expect_near("e = 0, the far contact first", run(0, false), Vec3(Real(1.5), Real(1.5), 0),
                    1e-6, "m/s");
}

GRADED_TEST(Lab6, PassesGrowFasterThanTheStack, 3, "L6.4") {
  const auto passes_until_at_rest = [](int boxes) {
    Stack stack(boxes);
    stack.fall(1);
    int passes = 0;
    while (stack.approach() > Real(0.01) && passes < 10000) {
      resolve_contacts_naive(stack.constraints, stack.bodies);
      ++passes;
    }
    return passes;
  };
  Story story("Twice the boxes need three times the passes: the naive solver scales badly");
  story.when("passes until no contact approaches faster than 1 % of g·h");
  story
      .likely(
          "constraints are visited once per call, in order, and each call goes on from the last")
      .likely("only approaching bodies collide: v_n < 0");
  const int ten = passes_until_at_rest(10);
  const int twenty = passes_until_at_rest(20);
  const int one = passes_until_at_rest(1);
  story.expect_equal("passes for one box", one, 1);
  // The slowest error of N boxes shrinks by cos²(π/(2N + 1)) a pass: some N² passes for a high stack.
  story.expect_at_least("passes for 20 boxes / for 10", double(twenty) / ten, 2.5);
  story.expect_at_most("passes for 20 boxes", twenty, 9999);
}

}  // namespace
}  // namespace cs550::test
