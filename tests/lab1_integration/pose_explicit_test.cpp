// L1.6: position, and the explicit rotation with its known errors.
#include <cs550/graded_test.hpp>

#include "helpers/story.hpp"
#include "lab1_integration/convergence.hpp"
#include "lab1_integration/kinematic_body.hpp"
#include "lab1_integration/pictures.hpp"

namespace cs550::test {
namespace {

constexpr RotationMethod explicit_method = RotationMethod::Explicit;

Story with_explicit_causes(Story story) {
  return story.likely("the rate of change is ½·(0, ω)·q: mind the ½")
      .likely("a world-frame ω stands on the left of q; on the right it would be in the body frame")
      .likely("after the sum, q is too long: normalise it in every step");
}

GRADED_TEST(Lab1, FreeFallFollowsTheClosedForm, 3, "L1.6") {
  Story story("Free fall stays below x₀ + v₀·t + ½·g·t² by exactly ½·g·h·t");
  story.when("integrate_momentum, refresh_velocity, integrate_pose for 1 s");
  story.likely("P += F without the h makes a fall depend on the frame rate")
      .likely("the position moves by v·h, not by the momentum and not by v alone")
      .likely("the order: momentum first, then velocity from it, then position");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    for (const int rate : {30, 60, 240}) {
      const Real h = Real(1) / static_cast<Real>(rate);
      const Vec3 g = size * Vec3(0, 0, Real(-9.81));
      const Vec3 v0 = size * Vec3(2, -1, 3);
      RigidBody body = box(size * Vec3(Real(0.5), Real(0.5), Real(0.5)));
      body.linear_momentum = body.mass * v0;
      body.force = body.mass * g;
      std::vector<Vec3> path = {body.pose.position};
      for (int i = 0; i < rate; ++i) {
        integrate_momentum(body, h);
        refresh_velocity(body);
        integrate_pose(body, h, explicit_method);
        path.push_back(body.pose.position);
      }
      Story here = story;
      here.given("size", size, "m").given("g", g, "m/s²").given("v₀", v0, "m/s").given("h", h, "s");
      here.picture([&] { return fall_picture(path, v0, g, h); });
      // Rounding of up to 240 sums to half a unit in the seventh digit; ½·g·h·t is 1000 times more.
      here.expect_near("position after 1 s", body.pose.position,
                       v0 + Real(0.5) * g + Real(0.5) * h * g, 2e-5 * size, "m");
    }
  }
}

GRADED_TEST(Lab1, ExplicitTurnOfAKinematicBody, 2, "L1.6") {
  KinematicBody kinematic(16);
  const Real h = Real(0.01);
  for (int i = 0; i < 100; ++i) integrate_pose(kinematic.body, h, explicit_method);

  Story story = with_explicit_causes(Story("A step along the tangent turns by 2·atan(½·h·|ω|)"));
  story.seed(kinematic.random.seed())
      .given("a kinematic body with constant ω", kinematic.w, "rad/s")
      .given("h", h, "s")
      .when("100 steps");
  // q + ½h(0, ω)q has the length sqrt(1 + ¼h²ω²): the step is a right triangle, not an arc.
  kinematic.expect_after_a_second(
      story, 100 * 2 * std::atan(0.5 * double{h} * double{kinematic.w.norm()}));
  story.expect_at_most("|q| off 1 by", length_error(kinematic.body.pose.orientation), 1e-6);

  RigidBody fixed = make_immovable_body(BodyKind::Static, Pose{Vec3(1, 2, 3), kinematic.start});
  refresh_velocity(fixed);
  integrate_pose(fixed, h, explicit_method);
  Story still("A static body stays where it is");
  still.expect_near("position", fixed.pose.position, Vec3(1, 2, 3), 0, "m");
  still.expect_at_most("turned by",
                       orientation_error(fixed, kinematic.start.cast<double>().normalized()), 1e-6,
                       "rad");
}

GRADED_TEST(Lab1, ExplicitStepConvergesAtFirstOrder, 2, "L1.6") {
  expect_order(
      with_explicit_causes(Story("Half the step, half the error: the explicit step is of order 1")),
      explicit_method, 1, 240);
}

GRADED_TEST(Lab1, ExplicitTurnClimbsToTheGreatestEnergy, 3, "L1.6") {
  const Vec3 spin(Real(0.5), 5, Real(0.5));
  RigidBody body = spinning_box(racket, spin);
  const Vec3 momentum = body.angular_momentum;
  const double energy = rotational_energy(body);
  double greatest = energy;
  double mismatch = 0;
  double length = 0;
  for (int i = 0; i < 20 * 60; ++i) {
    turn(body, Real(1) / 60, explicit_method);
    greatest = std::max(greatest, rotational_energy(body));
    mismatch = std::max(mismatch, momentum_mismatch(body, momentum));
    length = std::max(length, length_error(body.pose.orientation));
  }
  Story story =
      with_explicit_causes(Story("The explicit step drives a body to turn about its long axis"));
  story.given("half-extents", racket, "m").given("body ω", spin, "rad/s");
  story.when("20 s at 60 Hz without forces");
  // L is fixed, so the energy ½·L²/I can grow until the axis of least inertia carries all of L.
  const double limit =
      momentum.cast<double>().squaredNorm() / (2 * body.inertia.diagonal().minCoeff() * energy);
  story.expect_near("greatest energy / initial energy", greatest / energy, limit, 1e-3 * limit);
  story.expect_near("which is almost I_y/I_z", greatest / energy, 3.586, 1e-3 * 3.586);
  story.expect_at_most("R·I·Rᵀ·ω off the initial L by, relative", mismatch, 1e-5);
  story.expect_at_most("|q| off 1 by", length, 1e-6);
}

}  // namespace
}  // namespace cs550::test
