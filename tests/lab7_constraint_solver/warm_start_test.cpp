#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"

namespace cs550::test {
namespace {

/// Roundings of float in a few products and sums, relative to the largest term.
constexpr double warm_start_rounding = 5e-6;

/// Two bodies with accumulated impulses that change speeds by some m/s.
Meeting loaded_meeting(Random& random) {
  Meeting meeting = random_meeting(random);
  ContactConstraint& constraint = meeting.constraint;
  const Real unit = constraint.normal_mass;
  constraint.normal_impulse = unit * random.real(0, 2);
  constraint.tangent_impulse.x() = unit * random.real(-1, 1);
  constraint.tangent_impulse.y() = unit * random.real(-1, 1);
  return meeting;
}

GRADED_TEST(Lab7, WarmStartAppliesTheAccumulatedImpulses, 2, "L7.5") {
  Random random(7501);
  Story story("warm starting adds M⁻¹·Jᵀ·λ to the velocities, for λ_n, λ_u and λ_v");
  story.seed(random.seed());
  Story without_friction = story;
  without_friction.likely(
      "the friction impulses λ_u and λ_v are applied again, too, not λ_n alone");
  story.likely("λ ≥ 0 pushes apart: −λ·n to A and +λ·n to B")
      .likely("the second tangent is constraint.v() = n × u")
      .likely("the impulse acts at r_A and r_B, not at the centres");
  for (int i = 0; i < 200; ++i) {
    Meeting meeting = loaded_meeting(random);
    const Meeting before = meeting;
    const Vec12 expected = meeting.velocity_after(meeting.impulses());
    warm_start(meeting.constraint, meeting.a, meeting.b);
    const Vec12 got = meeting.velocity();
    const Vec12 normal_alone = before.velocity_after({before.impulses()[0], 0, 0});
    const double tolerance = warm_start_rounding * (1 + expected.norm());
    Story& here = (got - normal_alone).norm() <= tolerance ? without_friction : story;
    const auto part = [](const Vec12& all, int first) {
      return Vec3(all.segment<3>(first).cast<Real>());
    };
    require(here.expect_near("v_A", part(got, 0), part(expected, 0), tolerance, "m/s"));
    require(here.expect_near("ω_A", part(got, 3), part(expected, 3), tolerance, "rad/s"));
    require(here.expect_near("v_B", part(got, 6), part(expected, 6), tolerance, "m/s"));
    require(here.expect_near("ω_B", part(got, 9), part(expected, 9), tolerance, "rad/s"));
  }
}

GRADED_TEST(Lab7, WarmStartConservesMomentum, 1, "L7.5") {
  Random random(7502);
  Story story("warm starting changes neither the sum of P nor that of L about the contact");
  story.seed(random.seed()).likely("what B gets, A gets with the opposite sign, at the same point");
  for (int i = 0; i < 100; ++i) {
    Meeting meeting = loaded_meeting(random);
    const Vec12 velocity = meeting.velocity();
    const auto before = meeting.momentum();
    warm_start(meeting.constraint, meeting.a, meeting.b);
    const Vec12 change = meeting.velocity() - velocity;
    const double moved = (meeting.momentum() - before).norm();
    // The change of each body is rounded separately, at the scale of its momentum.
    require(story.expect("the bodies have got an impulse", change.norm() > 0));
    require(story.expect_near("change of P and L", moved, 0,
                              warm_start_rounding * (1 + before.norm()), "N·s"));
  }
}

}  // namespace
}  // namespace cs550::test
