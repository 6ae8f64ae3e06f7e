// L1.7: the implicit midpoint rotation against closed forms and a reference in double precision.
#include <cs550/graded_test.hpp>

#include <vector>

#include "helpers/random.hpp"
#include "helpers/story.hpp"
#include "lab1_integration/convergence.hpp"
#include "lab1_integration/first_turn.hpp"
#include "lab1_integration/flips.hpp"
#include "lab1_integration/kinematic_body.hpp"
#include "lab1_integration/pictures.hpp"

namespace cs550::test {
namespace {

constexpr RotationMethod midpoint_method = RotationMethod::ImplicitMidpoint;

Story with_midpoint_causes(Story story) {
  return story.likely("w is the ω at the orientation *half* a step ahead, exp(½·h·w)·q")
      .likely("ω at another orientation is R·I⁻¹·Rᵀ·L there: both rotations change with q")
      .likely("without the iterations it is an explicit step again, which gains energy")
      .likely("in float, w need not stop changing: make three iterations, not as many as it takes")
      .likely("the turn by a world-frame h·w multiplies q from the left");
}

GRADED_TEST(Lab1, MidpointConvergesAtSecondOrder, 2, "L1.7") {
  expect_order(with_midpoint_causes(
                   Story("Half the step, a quarter of the error: the midpoint is of order 2")),
               midpoint_method, 2, 60);
}

GRADED_TEST(Lab1, MidpointKeepsTheEnergy, 3, "L1.7") {
  struct Case {
    Real speed;
    int rate;
    double bound;
  };
  for (const Case& at : {Case{5, 60, 1e-3}, Case{20, 60, 1e-2}, Case{20, 240, 1e-3}}) {
    const Vec3 spin = at.speed * Vec3(Real(0.1), 1, Real(0.1));
    RigidBody body = spinning_box(racket, spin);
    const double energy = rotational_energy(body);
    const Real h = Real(1) / static_cast<Real>(at.rate);
    Story story = with_midpoint_causes(Story("A body that turns freely keeps its energy"));
    story.given("half-extents", racket, "m").given("body ω", spin, "rad/s");
    story.given("rate", at.rate, "Hz").when("20 s without forces");
    story.picture(
        [&] { return tumbling_picture(spinning_box(racket, spin), 5, at.rate, midpoint_method); });
    require_first_turn(story, body, h, midpoint_method);
    double worst = 0;
    for (int i = 0; i < 20 * at.rate; ++i) {
      turn(body, h, midpoint_method);
      worst = std::max(worst, std::abs(rotational_energy(body) / energy - 1));
    }
    story.expect_at_most("largest change of the energy, relative", worst, at.bound);
  }
}

GRADED_TEST(Lab1, AngularMomentumLastsTenThousandSteps, 2, "L1.7") {
  RigidBody body = spinning_box(racket, Vec3(Real(0.5), 5, Real(0.5)));
  const Vec3 momentum = body.angular_momentum;
  Story story("R·I·Rᵀ·ω, recomputed from the pose, stays the initial L");
  story.given("half-extents", racket, "m").when("10 000 steps at 60 Hz without forces");
  story.likely("q drifts off unit length: normalise it after every step")
      .likely("integrate_pose() leaves the momenta as they are")
      .likely("ω must come from the inverse inertia at the present pose")
      .likely("in float, w need not stop changing: make three iterations, not as many as it takes");
  require_first_turn(story, body, Real(1) / 60, midpoint_method);
  double mismatch = 0;
  double length = 0;
  for (int i = 0; i < 10000; ++i) {
    turn(body, Real(1) / 60, midpoint_method);
    mismatch = std::max(mismatch, momentum_mismatch(body, momentum));
    length = std::max(length, length_error(body.pose.orientation));
  }
  story.expect_at_most("R·I·Rᵀ·ω off the initial L by, relative", mismatch, 1e-5);
  story.expect_at_most("|q| off 1 by", length, 1e-6);
}

GRADED_TEST(Lab1, SymmetricTopPrecesses, 2, "L1.7") {
  Random random(17);
  const Quat start = random.orientation();
  // I₁ = I₂: ω = L/I₁ + (1 − I₃/I₁)·ω₃·e₃, two constant rotations, about the fixed L and about the
  // body's own axis (Goldstein, Classical Mechanics, §5.6).
  RigidBody body = spinning_box(Vec3(Real(0.3), Real(0.3), 1), Vec3(1, 0, 4), start);
  const Vec3 v(1, -2, 3);
  body.linear_momentum = body.mass * v;
  refresh_velocity(body);
  const Eigen::Vector3d momentum = body.angular_momentum.cast<double>();
  const double i1 = body.inertia(0, 0);
  const double i3 = body.inertia(2, 2);
  const double spin = 4 * (1 - i3 / i1);
  const Real h = Real(1) / 240;
  Story story = with_midpoint_causes(Story("A symmetric top precesses about L by |L|/I₁"));
  story.seed(random.seed()).given("half-extents", Vec3(Real(0.3), Real(0.3), 1), "m");
  story.given("body ω", Vec3(1, 0, 4), "rad/s").when("2 s at 240 Hz");
  for (int i = 0; i < 2 * 240; ++i) turn(body, h, midpoint_method);

  const Eigen::Quaterniond precession(
      Eigen::AngleAxisd(2 * momentum.norm() / i1, momentum.normalized()));
  const Eigen::Quaterniond own_spin(Eigen::AngleAxisd(2 * spin, Eigen::Vector3d::UnitZ()));
  const Eigen::Quaterniond exact = precession * start.cast<double>().normalized() * own_spin;
  // The midpoint lags by (h·ω)²/12 of an angle: 2e-5 of some 10 rad.
  story.expect_at_most("orientation off by", orientation_error(body, exact), 3e-4, "rad");

  Story moved("A body that rotates moves by v·t");
  moved.given("v", v, "m/s").when("2 s at 240 Hz by the midpoint method");
  moved.likely("both methods move the position by v·h: they differ in the rotation only");
  // 480 additions, each rounded to half a unit in the seventh digit.
  moved.expect_near("position", body.pose.position, 2 * v, 2e-4, "m");
}

GRADED_TEST(Lab1, TumblingRacketFlipsOnTime, 2, "L1.7") {
  const std::vector<double> listed = {0.8526, 3.4814, 6.1102, 8.7389, 11.3677};
  const Vec3 spin(Real(0.5), 5, Real(0.5));
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    Story story =
        with_midpoint_causes(Story("Spun about its middle axis, a box flips at known times"));
    story.given("half-extents", Vec3(size * racket), "m").given("body ω", spin, "rad/s");
    story.when("12 s at 60 Hz without forces").picture([&] {
      return tumbling_picture(spinning_box(racket, spin), 4, 60, midpoint_method);
    });
    const std::vector<double> got = flip_times(spinning_box(size * racket, spin), 12);
    if (!story.expect_equal("number of flips", got.size(), listed.size())) continue;
    for (std::size_t i = 0; i < listed.size(); ++i)
      story.expect_near("flip " + std::to_string(i + 1), got[i], listed[i], 5e-3, "s");
  }
}

GRADED_TEST(Lab1, MidpointTurnOfAKinematicBody, 1, "L1.7") {
  KinematicBody kinematic(18);
  for (int i = 0; i < 60; ++i) integrate_pose(kinematic.body, Real(1) / 60, midpoint_method);

  Story story("A kinematic body turns by h·ω in every step, exactly");
  story.seed(kinematic.random.seed())
      .given("ω", kinematic.w, "rad/s")
      .when("60 steps of 1/60 s")
      .likely("a kinematic body has no L to derive ω from: its ω is constant, no iteration");
  kinematic.expect_after_a_second(story, double{kinematic.w.norm()});
}

}  // namespace
}  // namespace cs550::test
