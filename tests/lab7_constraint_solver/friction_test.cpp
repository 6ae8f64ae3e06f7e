#include <cs550/graded_test.hpp>

#include "dense_contact.hpp"
#include "helpers/story.hpp"
#include "pictures.hpp"

namespace cs550::test {
namespace {

Vec3 in_plane(double angle, double length) {
  return {static_cast<Real>(length * std::cos(angle)), static_cast<Real>(length * std::sin(angle)),
          0};
}

/// Checks an accumulated pair, in the plane of u and v.
void require_pair(Story& story, const Vec2& got, const Vec3& expected) {
  require(story.expect_near("λ_u", got.x(), expected.x(), 1e-5, "N·s"));
  require(story.expect_near("λ_v", got.y(), expected.y(), 1e-5, "N·s"));
}

/// A body of 2 kg that slides at 30 m/s and reaches the limit of 3 N·s in its first solve.
void require_slide(Story slide, Meeting meeting, double angle, int passes) {
  meeting.b.v = in_plane(angle, 30);
  meeting.constraint.friction = Real(0.5);
  meeting.constraint.normal_impulse = 6;
  for (int pass = 0; pass < passes; ++pass) {
    solve_friction(meeting.constraint, meeting.a, meeting.b);
  }
  slide.given("direction of the slip", angle, "rad").given("times solved", passes);
  const Vec2 impulse = meeting.constraint.tangent_impulse;
  slide.picture(
      [&] { return friction_picture(3, in_plane(angle, -3), impulse, in_plane(angle, 30)); });
  require_pair(slide, impulse, in_plane(angle, -3));
  require(slide.expect_near("velocity after", meeting.b.v, in_plane(angle, 30 - 1.5), 1e-5, "m/s"));
}

/// A beam above the contact. It turns easily about its axis, so that m_t is 1.6 kg along the beam and
/// 0.5 kg across it.
/// @param angle from u to the beam (rad): except along u or v, m_t has numbers beside its diagonal
Meeting beam(Real angle = 0) {
  Meeting meeting = landing(2, Vec3::Zero());
  const Mat3 turn = rotation_exp(Vec3(0, 0, angle)).toRotationMatrix();
  meeting.b.world_inverse_inertia =
      turn * Vec3(6, Real(0.5), Real(0.5)).asDiagonal() * turn.transpose();
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
  return meeting;
}

GRADED_TEST(Lab7, FrictionIsTheSameInEveryDirection, 1, "L7.7") {
  Story story("a fast slip gets exactly μ·λ_n against it, whatever its direction");
  story.given("a body of 2 kg that slides at 30 m/s, μ = 0.5, λ_n = 6 N·s");
  story.likely("limiting λ_u and λ_v separately is a box: up to √2·μ along its diagonal")
      .likely("the limit is μ times the *accumulated* normal impulse");
  Story cube = story;
  cube.given("a cube: m_t is the same along u and v");
  Story long_beam = story;
  long_beam.given("a beam: m_t is 1.6 kg along u, 0.5 kg along v")
      .likely("sliding friction points against the slip; the 2 × 2 mass turns away from it");
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.1 + k * static_cast<double>(pi) / 6;
    require_slide(cube, landing(2, Vec3::Zero()), angle, 1);
    require_slide(cube, landing(2, Vec3::Zero()), angle, 3);
    // A second solve would have another slip, because the first has turned the beam.
    require_slide(long_beam, beam(), angle, 1);
  }
}

/// Checks a slip whose m_t·slip is outside the disk, but s·slip inside.
void require_slide_inside_the_disk() {
  Story story("a sliding contact gets λ_acc − s·slip as it is, if that is inside the disk");
  story.given("a beam of 2 kg that slides along itself at 1 m/s, μ = 0.5, λ_n = 2 N·s")
      .given("m_t is 1.6 kg along the beam and 0.5 kg across it, so that s = 0.5 kg");
  story
      .likely("the pair that stops the slip decides: if it is outside the disk, the contact slides")
      .likely("a pair that is inside the disk already stays as it is: it is scaled back, never up");
  Meeting meeting = beam();
  meeting.b.v = Vec3(1, 0, 0);
  meeting.constraint.friction = Real(0.5);
  meeting.constraint.normal_impulse = 2;
  solve_friction(meeting.constraint, meeting.a, meeting.b);
  const Vec2 got = meeting.constraint.tangent_impulse;
  const Vec3 expected(Real(-0.5), 0, 0);
  story.picture([&] { return friction_picture(1, expected, got, Vec3(1, 0, 0)); });
  require_pair(story, got, expected);
}

GRADED_TEST(Lab7, SlidingFrictionUsesTheSmallerEigenvalue, 1, "L7.7") {
  Story story(
      "a sliding contact gets λ_acc − s·slip, scaled back; s: the smaller eigenvalue of m_t");
  story.given("a beam of 2 kg that slides at 8 m/s, μ = 0.5, λ_n = 4 N·s")
      .given("m_t is 1.6 kg along the beam and 0.5 kg across it, so that s = 0.5 kg")
      .given("accumulated: 1.5 N·s at a right angle to the slip");
  story
      .likely("s is the smaller eigenvalue of tangent_mass, not the larger one or an element of it")
      .likely("accumulate first, then scale the sum, then apply the difference");
  for (const Real angle : {Real(0.6), Real(-0.9)}) {
    for (int k = 0; k < 12; ++k) {
      const double direction = 0.1 + k * static_cast<double>(pi) / 6;
      const Vec3 slip = in_plane(direction, 8);
      const Vec3 accumulated = in_plane(direction + 0.5 * static_cast<double>(pi), 1.5);
      // m_t·slip is at least 0.5 · 8 = 4 N·s long. The 1.5 N·s leave 2.5 N·s of it or more: outside
      // the disk of 2 N·s.
      const Vec3 expected = 2 * (accumulated - Real(0.5) * slip).normalized();
      Meeting meeting = beam(angle);
      meeting.b.v = slip;
      meeting.constraint.friction = Real(0.5);
      meeting.constraint.normal_impulse = 4;
      meeting.constraint.tangent_impulse = accumulated.head<2>();
      Story slide = story;
      slide.given("angle from u to the beam", angle, "rad");
      slide.given("direction of the slip", direction, "rad");
      solve_friction(meeting.constraint, meeting.a, meeting.b);
      const Vec2 got = meeting.constraint.tangent_impulse;
      slide.picture([&] { return friction_picture(2, expected, got, slip); });
      require_pair(slide, got, expected);
    }
  }
  require_slide_inside_the_disk();
}

GRADED_TEST(Lab7, FrictionIsScaledBackOntoTheDisk, 1, "L7.7") {
  Story story("the accumulated pair is scaled back to ‖(λ_u, λ_v)‖ ≤ μ·λ_n, its direction kept");
  story.given("a cube of 2 kg, m_t = 0.8 kg, μ = 0.5");
  story.likely("accumulate first, then scale the sum, then apply the difference")
      .likely("less normal impulse means less friction: what is too much is given back");
  const auto solve = [&](Real normal, const Vec2& accumulated, const Vec3& velocity,
                         const Vec3& expected) {
    Meeting meeting = landing(2, velocity);
    meeting.constraint.friction = Real(0.5);
    meeting.constraint.normal_impulse = normal;
    meeting.constraint.tangent_impulse = accumulated;
    const Meeting before = meeting;
    solve_friction(meeting.constraint, meeting.a, meeting.b);
    Story contact = story;
    contact.given("λ_n", normal, "N·s").given("slip", Story::show(velocity, "m/s"));
    contact.given("accumulated λ_u", accumulated.x(), "N·s");
    contact.given("accumulated λ_v", accumulated.y(), "N·s");
    const Vec2 sum = meeting.constraint.tangent_impulse;
    const Vec2 change = sum - accumulated;
    contact.picture([&] { return friction_picture(normal / 2, expected, sum, velocity); });
    require_pair(contact, sum, expected);
    contact.expect_near("velocity after", meeting.b.v,
                        before.b.v + Vec3(change.x(), change.y(), 0) / 2, 1e-5, "m/s");
  };
  solve(20, {3, 0}, Vec3(0, -5, 0), Vec3(3, 4, 0));      // Inside the disk of 10 N·s: it sticks.
  solve(5, {3, 0}, Vec3(0, -5, 0), Vec3(1.5, 2, 0));     // (3, 4) is twice as long as 2.5 N·s.
  solve(4, {3, 4}, Vec3(0, 0, 0), Vec3(1.2f, 1.6f, 0));  // The load fell: so does the friction.
  solve(0, {3, 4}, Vec3(1, 0, 0), Vec3(0, 0, 0));        // No load, no friction.
}

GRADED_TEST(Lab7, CoupledTangentsStopTheSlipAtOnce, 1, "L7.7") {
  Random random(7701);
  Story story("within the limit, one solve with the 2 × 2 mass stops the slip along u and v");
  story.seed(random.seed());
  story.likely("u and v are coupled: λ is the matrix times the pair, not two products")
      .likely("friction works against the slip: the product is taken off what has accumulated")
      .likely("what is applied is the change along u and v, −λ to A and +λ to B");
  for (int i = 0; i < 200; ++i) {
    Meeting meeting = random_meeting(random);
    meeting.constraint.friction = 1;
    meeting.constraint.normal_impulse = Real(1e8);
    const Meeting before = meeting;
    solve_friction(meeting.constraint, meeting.a, meeting.b);
    const Eigen::Vector3d slip = meeting.contact_velocity();
    const double speed = 1 + before.contact_velocity().norm();
    Eigen::Vector3d change = meeting.impulses();
    change[0] = 0;
    const Vec12 expected = before.velocity_after(change);
    const double error = (meeting.velocity() - expected).norm();
    require(story.expect_near("slip along u", slip[1], 0, rounding * speed, "m/s"));
    require(story.expect_near("slip along v", slip[2], 0, rounding * speed, "m/s"));
    require(story.expect_near("distance of V' from V + M⁻¹·Jᵀ·λ", error, 0,
                              rounding * (1 + expected.norm())));
  }
}

}  // namespace
}  // namespace cs550::test
