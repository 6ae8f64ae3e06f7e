// L1.3 to L1.5: velocities derived from momenta, and the effect of a force over a time h.
#include <cs550/graded_test.hpp>

#include "helpers/random.hpp"
#include "helpers/story.hpp"
#include "lab1_integration/free_body.hpp"

namespace cs550::test {
namespace {

/// A body with an inertia that is not diagonal in the body frame, like most meshes.
RigidBody skew_body(Random& random, Real size) {
  RigidBody aligned = box(size * racket);
  const Mat3 tilt = random.orientation().toRotationMatrix();
  const Pose pose{size * random.unit_vector(), random.orientation()};
  return make_dynamic_body(aligned.mass, tilt * aligned.inertia * tilt.transpose(), pose);
}

GRADED_TEST(Lab1, WorldInverseInertiaMatchesDense, 4, "L1.3") {
  Random random(13);
  Story story("The inverse inertia in the world frame is (R·I·Rᵀ)⁻¹");
  story.seed(random.seed()).when("world_inverse_inertia() of a turned body");
  story.likely("R·I⁻¹·Rᵀ takes a world vector into the body (Rᵀ first), and back again (R last)")
      .likely("Rᵀ·I⁻¹·R turns the inertia the wrong way")
      .likely("the inertia of the body frame is not that of the world once the body has turned");
  for (const Real size : {Real(0.01), Real(0.3), Real(1), Real(100)}) {
    const RigidBody body = skew_body(random, size);
    const Eigen::Matrix3d exact = world_inertia(body).inverse();
    const Eigen::Matrix3d got = world_inverse_inertia(body).cast<double>();
    Story here = story;
    here.given("size of the body", size, "m");
    // Float keeps seven digits; the moments of inertia differ by a factor of four.
    here.expect_at_most("largest error, relative to the largest entry",
                        (got - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff(), 1e-5);
  }
}

GRADED_TEST(Lab1, VelocitiesFollowFromMomenta, 4, "L1.4") {
  Random random(14);
  Story story("v = P/m, and ω solves R·I·Rᵀ·ω = L");
  story.seed(random.seed())
      .when("refresh_velocity() before and after the body turns, with given P and L");
  story.likely("v = P/m: the momentum is divided by the mass, here and nowhere else")
      .likely("ω needs the inverse inertia at the *present* pose: world, not body frame, not stale")
      .likely("the inverse inertia is stored as well: the solvers read it");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    RigidBody body = skew_body(random, size);
    const Vec3 v = size * random.unit_vector();
    const Vec3 w = random.unit_vector();
    body.linear_momentum = body.mass * v;
    refresh_velocity(body);
    body.pose.orientation = random.orientation();
    body.angular_momentum = (world_inertia(body) * w.cast<double>()).cast<Real>();
    refresh_velocity(body);

    const Eigen::Matrix3d exact = world_inertia(body).inverse();
    Story here = story;
    here.given("size of the body", size, "m").given("mass", body.mass, "kg");
    here.expect_near("v", body.linear_velocity, v, 1e-5 * size, "m/s");
    here.expect_near("ω", body.angular_velocity, w, 1e-5, "rad/s");
    here.expect_at_most("error of the stored inverse inertia, relative",
                        (body.world_inverse_inertia.cast<double>() - exact).norm() / exact.norm(),
                        1e-5);
  }
}

void expect_no_inverse_inertia(Story& story, const RigidBody& body) {
  story.expect_near("largest element of its inverse inertia",
                    static_cast<double>(body.world_inverse_inertia.cwiseAbs().maxCoeff()), 0, 0,
                    "1/(kg·m²)");
}

GRADED_TEST(Lab1, ImmovableBodiesKeepOrHaveNoVelocity, 2, "L1.4") {
  RigidBody kinematic = make_immovable_body(BodyKind::Kinematic, Pose{});
  kinematic.linear_velocity = Vec3(1, 2, 3);
  kinematic.angular_velocity = Vec3(0, 0, 4);
  kinematic.world_inverse_inertia = Mat3::Identity();
  refresh_velocity(kinematic);
  Story owned("A kinematic body keeps the velocities that its owner gave it");
  owned.when("refresh_velocity()")
      .likely("a kinematic body's velocities are its state, not derived: do not overwrite them");
  owned.expect_near("v", kinematic.linear_velocity, Vec3(1, 2, 3), 0, "m/s");
  owned.expect_near("ω", kinematic.angular_velocity, Vec3(0, 0, 4), 0, "rad/s");
  expect_no_inverse_inertia(owned, kinematic);

  RigidBody fixed = make_immovable_body(BodyKind::Static, Pose{});
  fixed.linear_velocity = Vec3(1, 1, 1);
  fixed.angular_velocity = Vec3(1, 1, 1);
  fixed.world_inverse_inertia = Mat3::Identity();
  refresh_velocity(fixed);
  Story still("A static body has no velocity");
  still.given("velocities left over from another use")
      .when("refresh_velocity()")
      .likely("a static body's inverse mass and inertia are 0: the usual formulas give it rest");
  still.expect_near("v", fixed.linear_velocity, Vec3::Zero(), 0, "m/s");
  still.expect_near("ω", fixed.angular_velocity, Vec3::Zero(), 0, "rad/s");
  expect_no_inverse_inertia(still, fixed);
}

GRADED_TEST(Lab1, ForceActsForTheTimeStep, 3, "L1.5") {
  Story story("In a time h a force F changes P by F·h, and a torque τ changes L by τ·h");
  story.given("F", Vec3(6, 0, -12), "N").given("τ", Vec3(0, 3, 0), "N·m").given("h", 0.25f, "s");
  story.likely("P += F without the h makes a fall depend on the frame rate")
      .likely("the torque acts for the time h, too")
      .likely("forces stay gathered: the step may have more substeps, and the world clears them")
      .likely("only a dynamic body has momenta to change");
  for (const BodyKind kind : {BodyKind::Dynamic, BodyKind::Kinematic, BodyKind::Static}) {
    const bool free = kind == BodyKind::Dynamic;
    RigidBody body = free ? box(racket) : make_immovable_body(kind, Pose{});
    body.force = Vec3(6, 0, -12);
    body.torque = Vec3(0, 3, 0);
    integrate_momentum(body, Real(0.25));

    Story here = story;
    here.given(free ? "a dynamic body" : "a body that is not dynamic").when("integrate_momentum()");
    const Real share = free ? Real(0.25) : Real(0);
    here.expect_near("P", body.linear_momentum, share * Vec3(6, 0, -12), 1e-6, "kg·m/s");
    here.expect_near("L", body.angular_momentum, share * Vec3(0, 3, 0), 1e-6, "kg·m²/s");
    here.expect_near("force afterwards", body.force, Vec3(6, 0, -12), 0, "N");
    here.expect_near("torque afterwards", body.torque, Vec3(0, 3, 0), 0, "N·m");
    here.expect_near("v, which waits for refresh_velocity()", body.linear_velocity, Vec3::Zero(), 0,
                     "m/s");
    here.expect_near("ω, which waits for refresh_velocity()", body.angular_velocity, Vec3::Zero(),
                     0, "rad/s");
  }
}

GRADED_TEST(Lab1, MomentumDoesNotDependOnFrameRate, 2, "L1.5") {
  Story story("The momentum after a second does not depend on the number of steps");
  story.likely("P += F without the h makes a fall depend on the frame rate")
      .likely("the torque acts for the time h, too");
  for (const int rate : {1, 30, 60, 240}) {
    RigidBody body = box(racket);
    body.force = Vec3(0, 0, -10);
    body.torque = Vec3(2, 0, 0);
    for (int i = 0; i < rate; ++i) integrate_momentum(body, Real(1) / static_cast<Real>(rate));
    Story here = story;
    here.given("rate", rate, "Hz").given("F", body.force, "N").when("one second passes");
    // 240 additions, each rounded to half a unit in the seventh digit.
    here.expect_near("P", body.linear_momentum, Vec3(0, 0, -10), 1e-4, "kg·m/s");
    here.expect_near("L", body.angular_momentum, Vec3(2, 0, 0), 1e-4, "kg·m²/s");
  }
}

}  // namespace
}  // namespace cs550::test
