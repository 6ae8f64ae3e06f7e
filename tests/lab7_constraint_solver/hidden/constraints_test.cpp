// Other sizes, masses, roles and seeds for the constraint functions of lab 7.
#include <cs550/graded_test.hpp>

#include "helpers/story.hpp"
#include "lab7_constraint_solver/dense_contact.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, NormalImpulsesOfEverySizeAndRole, 3, "L7.6") {
  Random random(7611);
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (int i = 0; i < 60; ++i) {
      Meeting meeting = random_meeting(random, size);
      if (i % 3 == 1) meeting.a = immovable_body();
      if (i % 3 == 2) meeting.b = immovable_body();
      meeting.constraint.normal_impulse = meeting.constraint.normal_mass * size * random.real(0, 3);
      prepare_densely(meeting.constraint, meeting.a, meeting.b);
      const Meeting before = meeting;
      solve_normal(meeting.constraint, meeting.a, meeting.b, rigid_step());
      Story story("the sum grows or falls by m·v_n, but not below 0; V' = V + M⁻¹·Jᵀ·Δλ");
      story.seed(random.seed()).given("size", size, "m");
      story.given("immovable", i % 3 == 0 ? "none" : i % 3 == 1 ? "A" : "B");
      story.likely("clamp the sum, then apply the difference");
      const double mass = static_cast<double>(before.constraint.normal_mass);
      const double speed = before.contact_velocity()[0];
      const double sum = std::max(0.0, before.impulses()[0] - mass * speed);
      const double scale = before.impulses()[0] + mass * std::abs(speed);
      const Vec12 expected = before.velocity_after(meeting.impulses() - before.impulses());
      const double error = (meeting.velocity() - expected).norm();
      require(story.expect_near("accumulated after", meeting.impulses()[0], sum, rounding * scale,
                                "N·s"));
      require(story.expect_near("distance of V' from V + M⁻¹·Jᵀ·Δλ", error, 0,
                                rounding * (before.velocity().norm() + expected.norm())));
    }
  }
}

GRADED_TEST(Lab7, FrictionOnAMovingGround, 3, "L7.7") {
  for (const double mu : {0.2, 1.5}) {
    for (int k = 0; k < 12; ++k) {
      const double angle = 0.25 + k * static_cast<double>(pi) / 6;
      Story story("friction acts against the velocity relative to the ground, up to μ·λ_n");
      story.given("a cube of 5 kg at rest on a belt that moves at 20 m/s, λ_n = 4 N·s");
      story.given("μ", mu).given("direction", angle, "rad");
      story.likely("the slip is B's velocity less A's, both at the contact")
          .likely("λ_u and λ_v share one limit");
      const Vec3 along(static_cast<Real>(std::cos(angle)), static_cast<Real>(std::sin(angle)), 0);
      Meeting meeting = landing(5, Vec3::Zero());
      meeting.a.v = 20 * along;
      meeting.constraint.friction = static_cast<Real>(mu);
      meeting.constraint.normal_impulse = 4;
      for (int pass = 0; pass < 2; ++pass) solve_friction(meeting.constraint, meeting.a, meeting.b);
      const Vec3 expected = static_cast<Real>(4 * mu / 5) * along;
      require(story.expect_near("velocity of the cube", meeting.b.v, expected, 1e-5, "m/s"));
      require(story.expect_near("velocity of the belt", meeting.a.v, Vec3(20 * along), 0, "m/s"));
    }
  }
}

}  // namespace
}  // namespace cs550::test
