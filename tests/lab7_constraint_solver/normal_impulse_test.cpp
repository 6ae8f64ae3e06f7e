#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, OneImpulseStopsTheApproach, 2, "L7.6") {
  Random random(7601);
  Story story("after one solve of one constraint, J·v + b = 0 and V' = V + M⁻¹·Jᵀ·λ");
  story.seed(random.seed())
      .likely("λ = −m·(Jv + b): the sign makes λ positive when the bodies approach")
      .likely("λ·n goes to B and −λ·n to A, at r_B and r_A")
      .likely("the separation keeps its sign: a gap and a depth ask for different biases");
  ContactStep step = rigid_step();
  step.model = ContactModel::Baumgarte;
  for (int i = 0; i < 200; ++i) {
    Meeting meeting = random_meeting(random);
    make_approach(meeting);
    const double approach = -meeting.contact_velocity()[0];
    // If separated, some approach is allowed. If deep, a push is added.
    const double depth = i % 3 - 1;
    const double b = depth > 0 ? 0.5 * approach : depth;
    const double h = static_cast<double>(step.h);
    const double rate = depth > 0 ? 1 / h : static_cast<double>(step.baumgarte) / h;
    meeting.constraint.separation = static_cast<Real>(b / rate);
    const Meeting before = meeting;
    solve_normal(meeting.constraint, meeting.a, meeting.b, step);

    Story contact = story;
    contact.given("separation", meeting.constraint.separation, "m").given("b", b, "m/s");
    contact.given("approach before", approach, "m/s");
    const double left = meeting.contact_velocity()[0] + b;
    const Vec12 expected = before.velocity_after(meeting.impulses());
    const double error = (meeting.velocity() - expected).norm();
    require(contact.expect_near("Jv + b", left, 0, rounding * (1 + approach), "m/s"));
    require(contact.expect_near("distance of V' from V + M⁻¹·Jᵀ·λ", error, 0,
                                rounding * (1 + expected.norm())));
  }
}

GRADED_TEST(Lab7, AnImpulseMayGoBackDownButNeverPulls, 2, "L7.6") {
  Story story("the *sum* of a constraint's impulses is kept ≥ 0; a single one may be negative");
  story.given("a cube of 2 kg above a floor, moving away from it");
  story.likely("clamp what the constraint has accumulated, not the increment")
      .likely("apply the difference of the sums, not the impulse before clamping");
  const auto solve = [&](Real accumulated, Real speed, double sum, double speed_after) {
    Meeting meeting = landing(2, Vec3(0, 0, speed));
    meeting.constraint.normal_impulse = accumulated;
    solve_normal(meeting.constraint, meeting.a, meeting.b, rigid_step());
    Story contact = story;
    contact.given("accumulated", accumulated, "N·s").given("v_n", speed, "m/s");
    contact.expect_near("accumulated after", static_cast<double>(meeting.constraint.normal_impulse),
                        sum, 1e-6, "N·s");
    contact.expect_near("v_n after", static_cast<double>(meeting.b.v.z()), speed_after, 1e-6,
                        "m/s");
  };
  solve(0, 3, 0, 3);           // Nothing to reduce: the bodies separate freely.
  solve(10, 3, 4, 0);          // Too large: it is reduced by 2 kg · 3 m/s.
  solve(4, 3, 0, 1);           // It is reduced to zero, not below.
  solve(4, Real(-1.5), 7, 0);  // If the bodies approach, the sum increases.
  solve(6, 3, 0, 0);           // Reduced to exactly zero.
}

GRADED_TEST(Lab7, NormalImpulsesConserveMomentum, 1, "L7.6") {
  Random random(7602);
  Story story("an impulse changes neither the sum of P nor that of L about the contact");
  story.seed(random.seed()).likely("A gets the opposite of what B gets, at the same point");
  for (int i = 0; i < 100; ++i) {
    Meeting meeting = random_meeting(random);
    make_approach(meeting);
    const auto before = meeting.momentum();
    solve_normal(meeting.constraint, meeting.a, meeting.b, rigid_step());
    const double moved = (meeting.momentum() - before).norm();
    const double speed = 1 + stacked(meeting.a, meeting.b).norm();
    require(
        story.expect_near("v_n after", meeting.contact_velocity()[0], 0, rounding * speed, "m/s"));
    require(
        story.expect_near("change of P and L", moved, 0, rounding * (1 + before.norm()), "N·s"));
  }
}

GRADED_TEST(Lab7, SoftnessScalesTheMassAndTheSum, 1, "L7.6") {
  Story story("soft: λ = −m_scale·m·(Jv + b) − λ_scale·λ_acc; in relax passes λ = −m·Jv");
  story.given("2 kg, v_n = −3 m/s, 20 mm deep, rate 10/s, m_scale ¾, λ_scale ¼, λ_acc = 4 N·s");
  story.likely("the scales are those that contact_bias() returns")
      .likely("λ_scale takes away a share of what has been accumulated before")
      .likely("the mass is the constraint's normal_mass, which the world may have over-relaxed");
  const auto solve = [&](bool use_bias, Real mass, double sum, double speed_after) {
    Meeting meeting = landing(2, Vec3(0, 0, -3));
    meeting.constraint.softness = {10, Real(0.75), Real(0.25)};
    meeting.constraint.separation = Real(-0.02);
    meeting.constraint.normal_impulse = 4;
    meeting.constraint.normal_mass = mass;
    ContactStep step = rigid_step();
    step.use_bias = use_bias;
    Story contact = story;
    contact.given(use_bias ? "pass with bias" : "relax pass").given("normal_mass", mass, "kg");
    solve_normal(meeting.constraint, meeting.a, meeting.b, step);
    contact.expect_near("accumulated after", static_cast<double>(meeting.constraint.normal_impulse),
                        sum, 1e-5, "N·s");
    contact.expect_near("v_n after", static_cast<double>(meeting.b.v.z()), speed_after, 1e-5,
                        "m/s");
  };
  solve(true, 2, 7.8, -1.1);  // −¾ · 2 · (−3 − 0.2) − ¼ · 4 = 3.8
  solve(false, 2, 10, 0);     // −2 · −3 = 6: relaxing is rigid.
  solve(false, 3, 13, 1.5);   // −3 · −3 = 9: it overshoots by half.
}

GRADED_TEST(Lab7, TheSeparationFollowsTheBodies, 1, "L7.6") {
  Random random(7603);
  Story story("the present separation is the constraint's plus J·(Δx_A, Δθ_A, Δx_B, Δθ_B)");
  story.seed(random.seed())
      .likely(
          "the constraint knows the separation of the start of the step; the bodies have moved "
          "since")
      .likely("a turn moves the contact by Δθ × r");
  const ContactStep step = rigid_step();
  for (int i = 0; i < 100; ++i) {
    Meeting meeting = random_meeting(random);
    make_approach(meeting);
    const auto move = [&](SolverBody& body) {
      body.delta_position = random.point_in_box(Vec3::Constant(Real(0.02)));
      body.delta_rotation = random.point_in_box(Vec3::Constant(Real(0.02)));
    };
    move(meeting.a);
    move(meeting.b);
    Vec12 moved;
    moved << wide(meeting.a.delta_position), wide(meeting.a.delta_rotation),
        wide(meeting.b.delta_position), wide(meeting.b.delta_rotation);
    const double closed = dense_jacobians(meeting.constraint).row(0).dot(moved);
    // A gap that half of the approach would close in the substep.
    const double half = -0.5 * meeting.contact_velocity()[0];
    const double gap = half * static_cast<double>(step.h);
    meeting.constraint.separation = static_cast<Real>(gap - closed);
    solve_normal(meeting.constraint, meeting.a, meeting.b, step);
    Story contact = story;
    contact.given("separation at the start", meeting.constraint.separation, "m");
    contact.given("separation now", gap, "m");
    // A rounding of the separation, some cm, is multiplied by 1/h.
    require(contact.expect_near("v_n after", meeting.contact_velocity()[0], -half,
                                rounding * (1 + half), "m/s"));
  }
}

}  // namespace
}  // namespace cs550::test
