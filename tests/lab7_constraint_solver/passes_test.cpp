#include <cs550/graded_test.hpp>

#include "dense_lcp.hpp"
#include "helpers/story.hpp"
#include "systems.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, SequentialImpulsesFindTheAnswerOfTheWholeSystem, 2, "L7.8") {
  Random random(7801);
  Story story(
      "repeated passes converge to the λ ≥ 0, JV + b ≥ 0, λ·(JV + b) = 0 of all constraints");
  story.seed(random.seed());
  story
      .likely(
          "each constraint sees the velocities that the constraints before it have left: take "
          "references")
      .likely("impulses accumulate from pass to pass: only the sum is clamped");
  int pushing_constraints = 0;
  for (int i = 0; i < 40; ++i) {
    System system =
        i % 2 == 0 ? random_system(random) : landing_box(random, Vec3(Real(0.2), Real(0.6), 1));
    const DenseContacts before(system.constraints, system.bodies);
    const std::optional<Eigen::VectorXd> impulses = solve_lcp(before);
    require(story.expect("a solution exists", impulses.has_value()));
    for (Eigen::Index k = 0; k < impulses->size(); ++k) pushing_constraints += (*impulses)[k] > 0;
    system.pass(1000, rigid_step());
    const DenseContacts after(system.constraints, system.bodies);
    const double error = (after.velocity - before.velocity_after(*impulses)).norm();
    Story here = story;
    here.given(i % 2 == 0 ? "three bodies, four contacts" : "a box that lands on four corners");
    here.when("1000 passes");
    // Float cannot resolve a residual below some roundings of the speeds.
    require(here.expect_near("distance of the velocities from the dense answer", error, 0,
                             1e-4 * (1 + before.velocity.norm()), "m/s"));
  }
  story.expect_at_least("constraints that push, in all systems", pushing_constraints, 40);
}

GRADED_TEST(Lab7, ConstraintsAreVisitedInOrder, 1, "L7.8") {
  Story story(
      "one pass visits the constraints from the first to the last, or from the last to the first");
  story.given("three equal cubes in a line that touch; the first moves at 1 m/s").when("one pass");
  story.likely("ContactStep::backwards turns the order round")
      .likely(
          "take the bodies by reference: the second constraint must see what the first has done");
  const auto check = [&story](bool backwards, const Vec3& expected) {
    System line = line_of_cubes(3);
    ContactStep step = rigid_step();
    step.backwards = backwards;
    line.pass(1, step);
    Story pass = story;
    pass.given(backwards ? "backwards" : "forwards");
    pass.expect_near("speeds of the three",
                     Vec3(line.bodies[0].v.x(), line.bodies[1].v.x(), line.bodies[2].v.x()),
                     expected, 1e-6, "m/s");
  };
  check(false, Vec3(Real(0.5), Real(0.25), Real(0.25)));
  check(true, Vec3(Real(0.5), Real(0.5), 0));
}

/// Checks one pass over two contacts of a body, which both push already, against its four parts one by one.
void require_order_of_parts(Story story, const Meeting& meeting, bool backwards) {
  story.given("two contacts, at x = ±0.3 m, λ_n = 2 N·s")
      .given(backwards ? "backwards" : "forwards");
  story.likely(
      "the friction of a constraint comes before the normal of the next, backwards after it");
  System pass{{meeting.a, meeting.b}, {meeting.constraint, meeting.constraint}};
  pass.constraints[1].r_b.x() *= -1;
  pass.prepare();
  for (ContactConstraint& constraint : pass.constraints) constraint.normal_impulse = 2;
  ContactStep step = rigid_step();
  step.backwards = backwards;
  System parts = pass;
  pass.pass(1, step);
  const auto normal = [&](std::size_t k) {
    solve_normal(parts.constraints[k], parts.bodies[0], parts.bodies[1], step);
  };
  const auto friction = [&](std::size_t k) {
    solve_friction(parts.constraints[k], parts.bodies[0], parts.bodies[1]);
  };
  if (backwards) {
    friction(1);
    normal(1);
    friction(0);
    normal(0);
  } else {
    normal(0);
    friction(0);
    normal(1);
    friction(1);
  }
  require(story.expect_near("v after", pass.bodies[1].v, parts.bodies[1].v, 1e-5, "m/s"));
  require(story.expect_near("ω after", pass.bodies[1].w, parts.bodies[1].w, 1e-5, "rad/s"));
}

GRADED_TEST(Lab7, APassAndItsReverseAreMirrorImages, 2, "L7.8") {
  Story story("a constraint is solved normal, then friction; backwards friction, then normal");
  story.given("a cube of 2 kg that lands at 3 m/s and slips at 4 m/s, μ = 0.5");
  story.likely("friction is limited by the normal impulse that the constraint has at that moment")
      .likely("backwards everything is reversed, also the two halves of a constraint");
  Meeting meeting = landing(2, Vec3(4, 0, -3));
  // The centre is not above the contact, so that friction and normal are coupled.
  meeting.constraint.r_b.x() = Real(0.3);
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
  meeting.constraint.friction = Real(0.5);
  const auto pass = [&](System& system, bool backwards) {
    ContactStep step = rigid_step();
    step.backwards = backwards;
    system.pass(1, step);
    return Meeting{system.bodies[0], system.bodies[1], system.constraints[0]};
  };
  // The contact slips, so that friction stays at its limit. 1e-5: roundings at a few m/s.
  System forwards{{meeting.a, meeting.b}, {meeting.constraint}};
  const Meeting first = pass(forwards, false);
  const double pushed = static_cast<double>(first.constraint.normal_impulse);
  story.expect_near("normal impulse after one pass forwards", pushed,
                    3 * static_cast<double>(meeting.constraint.normal_mass), 1e-5, "N·s");
  story.expect_near("friction after it", first.impulses().tail<2>().norm(), 0.5 * pushed, 1e-5,
                    "N·s");
  System reversed{{meeting.a, meeting.b}, {meeting.constraint}};
  const Meeting back = pass(reversed, true);
  story.expect_near("friction after one pass backwards", back.impulses().tail<2>().norm(), 0, 0,
                    "N·s");
  const Meeting last = pass(forwards, true);
  story.expect_near("v_n after a pass and its reverse", last.contact_velocity()[0], 0, 1e-5, "m/s");
  for (const bool backwards : {false, true}) require_order_of_parts(story, meeting, backwards);
}

}  // namespace
}  // namespace cs550::test
