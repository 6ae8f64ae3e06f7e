#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"

namespace cs550::test {
namespace {

constexpr Real h = Real(1) / 240;

ContactConstraint soft_constraint() {
  ContactConstraint constraint;
  constraint.softness = {20, Real(0.75), Real(0.25)};
  return constraint;
}

GRADED_TEST(Lab7, AGapMayCloseButNotMore, 1, "L7.3") {
  Story story("apart by d, the surfaces may approach at d/h: b = d/h in every pass");
  story.likely("the relax pass drops the push, not the gap: without d/h bodies hover apart");
  for (const ContactModel model : {ContactModel::Baumgarte, ContactModel::Soft}) {
    for (const bool use_bias : {true, false}) {
      ContactStep step = rigid_step(h);
      step.model = model;
      step.use_bias = use_bias;
      step.slop = Real(0.001);
      const ContactBias bias = contact_bias(soft_constraint(), Real(0.003), step);
      Story pass = story;
      pass.given("separation", 0.003, "m").given("substep", h, "s");
      pass.given(use_bias ? "pass with bias" : "relax pass");
      pass.expect_near("bias", static_cast<double>(bias.velocity), 0.72, 1e-6, "m/s");
      pass.expect_near("mass scale", static_cast<double>(bias.mass_scale), 1, 0);
      pass.expect_near("impulse scale", static_cast<double>(bias.impulse_scale), 0, 0);
    }
  }
}

GRADED_TEST(Lab7, BaumgarteUndoesAShareOfThePenetration, 1, "L7.3") {
  ContactStep step = rigid_step(h);
  step.model = ContactModel::Baumgarte;
  step.slop = Real(0.001);
  step.max_push_speed = 3;
  Story story("Baumgarte: b = (β/h)·min(0, d + slop), at least −max_push_speed");
  story.given("β", step.baumgarte).given("slop", step.slop, "m").given("substep", h, "s");
  story.likely("penetration is negative: d + slop, not d − slop")
      .likely("the bias that pushes apart is negative");
  const auto bias = [&](Real separation) {
    return static_cast<double>(contact_bias(soft_constraint(), separation, step).velocity);
  };
  // 0.2 · 240/s · (−0.011 + 0.001) m
  story.expect_near("bias, 11 mm deep", bias(Real(-0.011)), -0.48, 1e-5, "m/s");
  story.expect_near("bias, 0.5 mm deep, within the slop", bias(Real(-0.0005)), 0, 0, "m/s");
  Story limited("Baumgarte: b is at least −max_push_speed");
  limited.given("β", step.baumgarte).given("substep", h, "s").given("penetration", 1, "m");
  limited.given("max_push_speed", step.max_push_speed, "m/s");
  limited.likely("Baumgarte's push is limited: b is at least −max_push_speed, however deep it is");
  limited.expect_near("bias, 1 m deep, limited", bias(-1), -3, 0, "m/s");
  const ContactBias push = contact_bias(soft_constraint(), Real(-0.011), step);
  Story rigid("Baumgarte: the pass is rigid, with the scales 1 and 0");
  rigid.likely("the softness belongs to soft contacts: Baumgarte's scales are 1 and 0");
  rigid.expect_near("mass scale, 11 mm deep", static_cast<double>(push.mass_scale), 1, 0);
  rigid.expect_near("impulse scale, 11 mm deep", static_cast<double>(push.impulse_scale), 0, 0);
  step.use_bias = false;
  story.expect_near("bias in the relax pass", bias(Real(-0.011)), 0, 0, "m/s");
}

GRADED_TEST(Lab7, SoftContactsPushLikeADampedSpring, 2, "L7.3") {
  ContactStep step = rigid_step(h);
  step.slop = Real(0.001);
  step.max_push_speed = 3;
  Story story("soft: b = rate·d, at least −max_push_speed, with the constraint's scales");
  story.likely("a spring pushes from the surface on: the slop belongs to Baumgarte")
      .likely("the bias that pushes apart is negative")
      .likely("the scales belong to the pass with bias only: relaxing is rigid");
  const ContactBias pushing = contact_bias(soft_constraint(), Real(-0.01), step);
  story.expect_near("bias, 10 mm deep", static_cast<double>(pushing.velocity), -0.2, 1e-6, "m/s");
  story.expect_near("mass scale", static_cast<double>(pushing.mass_scale), 0.75, 0);
  story.expect_near("impulse scale", static_cast<double>(pushing.impulse_scale), 0.25, 0);
  const ContactBias touching = contact_bias(soft_constraint(), 0, step);
  Story surface("soft: a contact at d = 0 has the constraint's scales");
  surface.likely("a contact at d = 0 has no gap: it is soft, as if it were penetrating");
  surface.expect_near("mass scale at d = 0", static_cast<double>(touching.mass_scale), 0.75, 0);
  surface.expect_near("impulse scale at d = 0", static_cast<double>(touching.impulse_scale), 0.25,
                      0);
  const ContactBias deep = contact_bias(soft_constraint(), -1, step);
  Story limited("soft: b is at least −max_push_speed");
  limited.given("rate", soft_constraint().softness.bias_rate, "1/s").given("penetration", 1, "m");
  limited.given("max_push_speed", step.max_push_speed, "m/s");
  limited.likely("the spring's push is limited: b is at least −max_push_speed, however deep it is");
  limited.expect_near("bias, 1 m deep, limited", static_cast<double>(deep.velocity), -3, 0, "m/s");
  step.use_bias = false;
  const ContactBias relaxing = contact_bias(soft_constraint(), Real(-0.011), step);
  story.expect_near("bias in the relax pass", static_cast<double>(relaxing.velocity), 0, 0, "m/s");
  story.expect_near("mass scale in the relax pass", static_cast<double>(relaxing.mass_scale), 1, 0);
  story.expect_near("impulse scale in the relax pass", static_cast<double>(relaxing.impulse_scale),
                    0, 0);
}

GRADED_TEST(Lab7, PushAndBounceAreNeverAdded, 2, "L7.3") {
  ContactStep step = rigid_step(h);
  step.model = ContactModel::Baumgarte;
  step.restitution_threshold = Real(0.5);
  step.max_push_speed = 1;
  ContactConstraint constraint = soft_constraint();
  constraint.restitution = Real(0.5);
  Story story("Baumgarte: b = min(b_p, b_r) with b_r = e·v_n⁰ if e > 0 and v_n⁰ < −threshold");
  story.given("e", constraint.restitution).given("threshold", step.restitution_threshold, "m/s");
  story.given("max_push_speed", step.max_push_speed, "m/s");
  story.likely("the sum of push and bounce throws bodies higher than they fell from")
      .likely("v_n⁰ is the constraint's approach_velocity, negative when approaching")
      .likely("the limit is that of the push; a bounce has none");
  const auto bias = [&](Real approach, Real separation) {
    constraint.approach_velocity = approach;
    return static_cast<double>(contact_bias(constraint, separation, step).velocity);
  };
  // Push: 0.2 · 240/s · −0.01 m = −0.48 m/s.
  story.expect_near("bias, hit at 4 m/s, 10 mm deep", bias(-4, Real(-0.01)), -2, 1e-6, "m/s");
  story.expect_near("bias, hit at 0.6 m/s, 10 mm deep", bias(Real(-0.6), Real(-0.01)), -0.48, 1e-5,
                    "m/s");
  story.expect_near("bias, slower than the threshold", bias(Real(-0.4), 0), 0, 0, "m/s");
  story.expect_near("bias, hit at 4 m/s while 1 mm apart", bias(-4, Real(0.001)), -2, 1e-6, "m/s");
  step.use_bias = false;
  Story relaxing("Baumgarte: nothing bounces in the relax pass");
  relaxing.given("e", constraint.restitution);
  relaxing.likely("the bounce belongs to passes with bias, as the push does");
  relaxing.expect_near("bias, hit at 4 m/s", bias(-4, 0), 0, 0, "m/s");
  step.use_bias = true;
  step.model = ContactModel::Soft;
  story.expect_near("bias of a soft contact, which bounces later", bias(-4, 0), 0, 0, "m/s");
  step.model = ContactModel::Baumgarte;
  constraint.restitution = 0;
  Story inelastic("Baumgarte: without restitution a gap may close, however fast the approach");
  inelastic.given("e", constraint.restitution).given("substep", h, "s");
  inelastic.likely("a bounce needs e > 0: with e = 0 it would ask for 0, less than the gap's d/h");
  inelastic.expect_near("bias, hit at 4 m/s while 1 mm apart", bias(-4, Real(0.001)), 0.24, 1e-6,
                        "m/s");
}

}  // namespace
}  // namespace cs550::test
