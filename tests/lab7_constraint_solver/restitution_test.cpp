#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"
#include "systems.hpp"

namespace cs550::test {
namespace {

ContactStep bouncing_step(int sweeps) {
  ContactStep step = rigid_step();
  step.restitution_threshold = Real(0.5);
  step.restitution_iterations = sweeps;
  return step;
}

/// One sweep over the constraint of a contact.
void bounce(Meeting& meeting) {
  SolverBody bodies[] = {meeting.a, meeting.b};
  apply_restitution({&meeting.constraint, 1}, bodies, bouncing_step(1));
  meeting.a = bodies[0];
  meeting.b = bodies[1];
}

GRADED_TEST(Lab7, ImpactsLeaveWithAShareOfTheirApproach, 1, "L7.9") {
  Random random(7901);
  Story story("a constraint that was hit leaves with v_n = −e·v_n⁰, and V' = V + M⁻¹·Jᵀ·Δλ");
  story.seed(random.seed());
  story
      .likely(
          "v_n⁰ is the constraint's approach_velocity, of before the warm start, not the present "
          "v_n")
      .likely("λ = −m·(v_n + e·v_n⁰) is added to what the constraint has accumulated")
      .likely("whether anything bounces is decided once; restitution_iterations ends the sweeps");
  for (int i = 0; i < 100; ++i) {
    Meeting meeting = random_meeting(random);
    meeting.constraint.restitution = random.real(Real(0.1), 1);
    meeting.constraint.approach_velocity = random.real(-6, -1);
    // Large enough that none is reduced to zero: v_n is some m/s.
    meeting.constraint.normal_impulse = 100 * meeting.constraint.normal_mass;
    const Meeting before = meeting;
    bounce(meeting);
    const double target = -static_cast<double>(meeting.constraint.restitution) *
                          static_cast<double>(meeting.constraint.approach_velocity);
    const Vec12 expected = before.velocity_after(meeting.impulses() - before.impulses());
    const double error = (meeting.velocity() - expected).norm();
    Story contact = story;
    contact.given("e", meeting.constraint.restitution);
    contact.given("v_n⁰", meeting.constraint.approach_velocity, "m/s");
    contact.given("v_n before", before.contact_velocity()[0], "m/s");
    require(contact.expect_near("v_n after", meeting.contact_velocity()[0], target, 10 * rounding,
                                "m/s"));
    require(contact.expect_near("distance of V' from V + M⁻¹·Jᵀ·Δλ", error, 0,
                                20 * rounding * (1 + expected.norm())));
  }
}

/// A contact without impulse touches if it arrives within two substeps at v_n⁰. Here these are 16.7 mm.
void expect_touching_by_arrival(const Story& story) {
  const char* others_first =
      "the first corners of a body stop it before the others arrive: those bounce, too";
  const char* limit = "the way of two substeps is −2·v_n⁰·h";
  const char* approach = "it is v_n⁰ that counts, the body may have been slowed down since";
  const char* now = "whether it arrives depends on the separation now: its body has moved since";
  const struct {
    const char* what;
    Real separation;  ///< when the step began
    Real moved;       ///< since, along the normal
    Real v_n;         ///< now; v_n⁰ is −4 m/s
    double v_n_after;
    const char* cause;
  } cases[] = {
      {"0.5 m above the floor", Real(0.5), 0, -4, -4, limit},
      {"20 mm above the floor, 2.4 substeps away", Real(0.02), 0, -4, -4, limit},
      {"15 mm above the floor, 1.8 substeps away", Real(0.015), 0, -4, 2, limit},
      {"10 mm above the floor", Real(0.01), 0, -4, 2, others_first},
      {"10 mm above the floor, slowed down to 0.5 m/s", Real(0.01), 0, Real(-0.5), 2, approach},
      {"0.5 m above the floor when the step began, and 10 mm now", Real(0.5), Real(-0.49), -4, 2,
       now},
  };
  for (const auto& at : cases) {
    Meeting hit = landing(2, Vec3::Zero());
    hit.constraint.restitution = Real(0.5);
    hit.constraint.approach_velocity = -4;
    hit.constraint.normal_impulse = 8;
    ContactConstraint arriving = hit.constraint;
    arriving.body_b = 2;
    arriving.normal_impulse = 0;
    arriving.separation = at.separation;
    ContactConstraint constraints[] = {hit.constraint, arriving};
    SolverBody bodies[] = {hit.a, hit.b, landing(2, Vec3(0, 0, at.v_n)).b};
    bodies[2].delta_position = Vec3(0, 0, at.moved);
    ContactStep step = bouncing_step(1);
    step.h = Real(1) / 480;
    apply_restitution(constraints, bodies, step);
    Story here = story;
    here.given("another cube, hit at 4 m/s, λ_n = 0, substep 1/480 s").given(at.what);
    here.likely(at.cause);
    here.expect_near("v_n of that cube", static_cast<double>(bodies[2].v.z()), at.v_n_after, 1e-6,
                     "m/s");
  }
}

GRADED_TEST(Lab7, OnlyFreshHardImpactsBounce, 1, "L7.9") {
  Story story(
      "constraints bounce if λ_n > 0, impact not yet handled, v_n⁰ < −threshold; λ_n > 0 marks it "
      "as handled");
  story.given("a cube of 2 kg at rest on a floor, e = 0.5, threshold 0.5 m/s");
  story.likely("a constraint without impulse has not been hit, however fast it approached")
      .likely("a constraint whose impact was handled has bounced already: its v_n⁰ is spent")
      .likely("mark every constraint with λ_n > 0, also those that do not bounce")
      .likely("whether anything bounces is decided once; restitution_iterations ends the sweeps");
  struct Case {
    const char* what;
    Real approach;
    Real impulse;
    bool impact_handled;
    double speed_after;
    bool handled_after;
  };
  const Case cases[] = {
      {"hit at 4 m/s", -4, 8, false, 2, true},
      {"hit at 0.4 m/s, below the threshold", Real(-0.4), 8, false, 0, true},
      {"at 4 m/s, but nothing was hit", -4, 0, false, 0, false},
      {"impact handled already", -4, 8, true, 0, true},
      {"impact handled already, and released", -4, 0, true, 0, true},
      {"parting", 4, 8, false, 0, true},
  };
  for (const Case& at : cases) {
    Meeting meeting = landing(2, Vec3::Zero());
    meeting.constraint.restitution = Real(0.5);
    meeting.constraint.approach_velocity = at.approach;
    meeting.constraint.normal_impulse = at.impulse;
    meeting.constraint.impact_handled = at.impact_handled;
    bounce(meeting);
    Story contact = story;
    contact.given(at.what);
    contact.expect_near("v_n after", static_cast<double>(meeting.b.v.z()), at.speed_after, 1e-6,
                        "m/s");
    contact.expect_equal("impact handled after", meeting.constraint.impact_handled,
                         at.handled_after);
  }
  Story without_bounce("without a constraint that bounces, restitution changes no velocity");
  without_bounce.given(
      "a cube of 2 kg on a floor, e = 0, hit at 4 m/s, still approaching at 1 m/s");
  without_bounce.likely("a constraint bounces only if e > 0, however fast it approached");
  Meeting inelastic = landing(2, Vec3(0, 0, -1));
  inelastic.constraint.approach_velocity = -4;
  inelastic.constraint.normal_impulse = 8;
  bounce(inelastic);
  without_bounce.expect_near("v_n after", static_cast<double>(inelastic.b.v.z()), -1, 0, "m/s");
  without_bounce.expect("impact handled after", inelastic.constraint.impact_handled);

  expect_touching_by_arrival(story);

  Meeting fast = landing(2, Vec3(0, 0, 5));
  fast.constraint.restitution = Real(0.5);
  fast.constraint.approach_velocity = -4;
  fast.constraint.normal_impulse = 2;
  bounce(fast);
  Story released = story;
  released.given("leaving at 5 m/s with λ_n = 2 N·s, hit at 4 m/s");
  released.likely("the sum is clamped at 0 here, too");
  released.expect_near("accumulated after", static_cast<double>(fast.constraint.normal_impulse), 0,
                       0, "N·s");
  released.expect_near("v_n after", static_cast<double>(fast.b.v.z()), 4, 1e-6, "m/s");
}

/// Checks a contact that touches only because it pushes, and that the first sweep releases: the second one must
/// not stop the lower cube on its way back to the floor.
void require_touching_at_each_visit() {
  Story story("a contact whose λ_n has fallen to 0 across a gap does not touch any more");
  story.given("a cube of 2 kg, 5 cm above the floor, that leaves it at 1 m/s with λ_n = 1 N·s")
      .given("another one at rest on it, hit at 4 m/s, e = 0.5")
      .when("two sweeps");
  story.likely("whether a contact touches is decided at each visit: the sweeps change λ_n");
  Meeting lower = landing(2, Vec3(0, 0, 1));
  lower.constraint.separation = Real(0.05);
  lower.constraint.normal_impulse = 1;
  ContactConstraint between = landing(2, Vec3::Zero()).constraint;
  between.body_a = 1;
  between.body_b = 2;
  between.r_a = -between.r_b;
  between.normal_mass = 1;
  between.restitution = Real(0.5);
  between.approach_velocity = -4;
  between.normal_impulse = 8;
  ContactConstraint constraints[] = {lower.constraint, between};
  SolverBody bodies[] = {lower.a, lower.b, landing(2, Vec3::Zero()).b};
  apply_restitution(constraints, bodies, bouncing_step(2));
  // Released by the floor, the lower cube rises at 0.5 m/s. The bounce of 2.5 N·s leaves 0.5 − 1.25.
  require(story.expect_near("v of the lower cube", static_cast<double>(bodies[1].v.z()), -0.75,
                            1e-6, "m/s"));
  require(story.expect_near("v of the upper cube", static_cast<double>(bodies[2].v.z()), 1.25, 1e-6,
                            "m/s"));
}

GRADED_TEST(Lab7, CornersReachTheirTargetsTogether, 1, "L7.9") {
  Story story("restitution_iterations sweeps bring all corners of a box to −e·v_n⁰");
  story.given("a 1:5 box that landed flat at 4 m/s, e = 0.5");
  story.likely("an impulse at one corner turns the box and moves the others: sweep again")
      .likely("impacts are marked as handled after the last sweep, not during the first")
      .likely("whether anything bounces is decided once; restitution_iterations ends the sweeps");
  for (const int sweeps : {0, 1, 40}) {
    System box = box_on_floor(Vec3(Real(0.1), Real(0.2), Real(0.5)));
    for (ContactConstraint& constraint : box.constraints) {
      constraint.restitution = Real(0.5);
      constraint.approach_velocity = -4;
      constraint.normal_impulse = 1;
    }
    apply_restitution(box.constraints, box.bodies, bouncing_step(sweeps));
    Story swept = story;
    swept.given("sweeps", sweeps);
    double worst = 0;
    for (const ContactConstraint& constraint : box.constraints) {
      const Meeting corner{box.bodies[0], box.bodies[1], constraint};
      worst = std::max(worst, std::abs(corner.contact_velocity()[0] - 2));
      swept.expect("every impact is marked as handled", constraint.impact_handled);
    }
    if (sweeps == 0) swept.expect_near("largest error of v_n", worst, 2, 0, "m/s");
    if (sweeps == 1) swept.expect_at_least("largest error of v_n", worst, 0.02, "m/s");
    // Each sweep reduces the error by at least a fifth: 0.8⁴⁰ ≈ 1e-4.
    if (sweeps == 40) swept.expect_at_most("largest error of v_n", worst, 1e-3, "m/s");
  }
  require_touching_at_each_visit();
}

}  // namespace
}  // namespace cs550::test
