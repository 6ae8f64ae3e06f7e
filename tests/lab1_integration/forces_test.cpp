// L1.1 and L1.2: the immediate effect of forces and impulses, before any time passes.
#include <cs550/graded_test.hpp>

#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "lab1_integration/pictures.hpp"

namespace cs550::test {
namespace {

/// The causes of a wrong force or torque. The one that gives exactly the torque found comes first.
Story with_force_causes(Story story, const Vec3& torque, const Eigen::Vector3d& expected,
                        const Eigen::Vector3d& about_origin, double tolerance) {
  const auto is = [&](const Eigen::Vector3d& other) {
    return (torque.cast<double>() - other).norm() <= tolerance &&
           (other - expected).norm() > 2 * tolerance;
  };
  const char* mass = "the mass has no part in a force: dP/dt = F, and only v = P/m divides";
  const char* lever = "the lever is measured from the centre of mass, not from the world's origin";
  const char* order = "the torque is lever × force; the other order turns the body the wrong way";
  if (is(-expected)) return story.likely(order).likely(lever).likely(mass);
  if (is(about_origin)) return story.likely(lever).likely(order).likely(mass);
  return story.likely(mass).likely(lever).likely(order);
}

Story with_impulse_causes(Story story) {
  return story.likely("an impulse changes L by lever × impulse, too: off centre, it turns the body")
      .likely("the lever is measured from the centre of mass, not from the world's origin")
      .likely("the velocities are derived afresh after an impulse: call refresh_velocity()")
      .likely("an impulse acts at once: no time step and no gathered force is part of it");
}

/// Checks that pose, momenta and velocities have not changed by a bit.
void expect_same_motion(Story& story, const RigidBody& body, const RigidBody& before) {
  story.expect("pose", body.pose.position == before.pose.position &&
                           body.pose.orientation.coeffs() == before.pose.orientation.coeffs());
  story.expect_near("P", body.linear_momentum, before.linear_momentum, 0, "kg·m/s");
  story.expect_near("L", body.angular_momentum, before.angular_momentum, 0, "kg·m²/s");
  story.expect_near("v", body.linear_velocity, before.linear_velocity, 0, "m/s");
  story.expect_near("ω", body.angular_velocity, before.angular_velocity, 0, "rad/s");
}

GRADED_TEST(Lab1, ForceAndTorqueGather, 3, "L1.1") {
  Random random(11);
  Story story("Forces at points add up to ΣF and Σ(p − x) × F");
  story.seed(random.seed()).when("three forces are added to a body that moves");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    const Pose pose{size * random.point_in_box(Vec3(5, 5, 5)), random.orientation()};
    RigidBody body = box(size * racket, pose);
    set_velocity(body, size * Vec3(1, -2, 3), Vec3(2, 1, -1));
    const RigidBody before = body;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();
    Eigen::Vector3d about_origin = Eigen::Vector3d::Zero();
    std::vector<Push> pushes;
    for (int i = 0; i < 3; ++i) {
      const Vec3 f = body.mass * random.unit_vector();
      const Vec3 point = pose.position + size * random.unit_vector();
      force += f.cast<double>();
      torque += (point - pose.position).cast<double>().cross(f.cast<double>());
      about_origin += point.cast<double>().cross(f.cast<double>());
      pushes.push_back({f, point});
      add_force(body, f, point);
    }
    // A few roundings of float, relative to three unit forces times the mass.
    const Real scale = body.mass;
    Story here = with_force_causes(story, body.torque, torque, about_origin, 1e-4 * scale * size);
    here.given("size of the body", size, "m").given("mass", body.mass, "kg");
    here.picture([&] {
      return lever_picture(pose, size * racket, pushes, size, "torque", torque.cast<Real>(),
                           body.torque);
    });
    here.expect_near("gathered force", body.force, force.cast<Real>(), 1e-5 * scale, "N");
    here.expect_near("gathered torque", body.torque, torque.cast<Real>(), 1e-5 * scale * size,
                     "N·m");
    here.likely("forces only gather: what they do to the velocities is the integration's work");
    expect_same_motion(here, body, before);
  }
}

/// The same push as at the side of a dynamic body.
void expect_force_on_immovable_bodies(const Pose& pose) {
  for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic}) {
    RigidBody body = make_immovable_body(kind, pose);
    Story story("Forces on a body that is not dynamic are gathered, too");
    story.given(kind == BodyKind::Static ? "a static body" : "a kinematic body")
        .given("position", pose.position, "m")
        .when("a force of 10 N along y acts 2 m further along x")
        .likely("add_force() treats every kind of body alike: the integration ignores such forces");
    add_force(body, Vec3(0, 10, 0), pose.position + Vec3(2, 0, 0));
    story.expect_near("force", body.force, Vec3(0, 10, 0), 0, "N");
    story.expect_near("torque", body.torque, Vec3(0, 0, 20), 0, "N·m");
  }
}

GRADED_TEST(Lab1, ForceOffCentreGivesTorque, 2, "L1.1") {
  Story story("A force turns a body about the axis lever × force");
  const Pose pose{Vec3(3, 0, 0), Quat::Identity()};
  story.given("centre of mass", pose.position, "m").given("mass", 4000.0f, "kg");

  RigidBody pushed_centrally = box(Vec3(1, 1, Real(0.5)), pose);
  add_force(pushed_centrally, Vec3(0, 10, 0), pose.position);
  Story centrally = with_force_causes(story, pushed_centrally.torque, Eigen::Vector3d::Zero(),
                                      Eigen::Vector3d(0, 0, 30), 1e-6);
  centrally.when("a force of 10 N along y acts at the centre of mass");
  centrally.expect_near("force", pushed_centrally.force, Vec3(0, 10, 0), 0, "N");
  centrally.expect_near("torque", pushed_centrally.torque, Vec3::Zero(), 0, "N·m");

  RigidBody pushed_at_side = box(Vec3(1, 1, Real(0.5)), pose);
  add_force(pushed_at_side, Vec3(0, 10, 0), pose.position + Vec3(2, 0, 0));
  Story aside = with_force_causes(story, pushed_at_side.torque, Eigen::Vector3d(0, 0, 20),
                                  Eigen::Vector3d(0, 0, 50), 1e-6);
  aside.when("a force of 10 N along y acts 2 m further along x");
  aside.picture([&] {
    const std::vector<Push> push{{Vec3(0, 10, 0), pose.position + Vec3(2, 0, 0)}};
    return lever_picture(pose, Vec3(1, 1, Real(0.5)), push, 2, "torque", Vec3(0, 0, 20),
                         pushed_at_side.torque);
  });
  aside.expect_near("torque", pushed_at_side.torque, Vec3(0, 0, 20), 0, "N·m");
  aside.expect_near("linear momentum, before any time has passed", pushed_at_side.linear_momentum,
                    Vec3::Zero(), 0, "kg·m/s");
  aside.expect_near("angular momentum, before any time has passed", pushed_at_side.angular_momentum,
                    Vec3::Zero(), 0, "kg·m²/s");
  expect_force_on_immovable_bodies(pose);
}

GRADED_TEST(Lab1, ImpulseChangesMomentaAndVelocities, 4, "L1.2") {
  Random random(12);
  Story story = with_impulse_causes(
      Story("An impulse j at p gives ΔP = j and ΔL = (p − x) × j, and velocities that follow"));
  story.seed(random.seed()).when("apply_impulse()");
  for (const Real size : {Real(1), Real(0.01), Real(100)}) {
    const Pose pose{size * random.point_in_box(Vec3(5, 5, 5)), random.orientation()};
    RigidBody body = box(size * racket, pose);
    set_velocity(body, size * random.unit_vector(), random.unit_vector());
    body.force = Vec3(1, 2, 3);
    body.torque = Vec3(4, 5, 6);
    const RigidBody before = body;
    const Vec3 impulse = body.mass * size * random.unit_vector();
    const Vec3 point = pose.position + size * random.unit_vector();
    apply_impulse(body, impulse, point);

    const Eigen::Vector3d lever = (point - pose.position).cast<double>();
    const Eigen::Vector3d momentum = before.linear_momentum.cast<double>() + impulse.cast<double>();
    const Eigen::Vector3d spin =
        before.angular_momentum.cast<double>() + lever.cross(impulse.cast<double>());
    const Eigen::Vector3d w = world_inertia(before).inverse() * spin;
    Story here = story;
    here.given("size of the body", size, "m").given("lever p − x", Vec3(lever.cast<Real>()), "m");
    here.given("impulse", impulse, "N·s");
    here.picture([&] {
      const Vec3 expected = lever.cross(impulse.cast<double>()).cast<Real>();
      return lever_picture(pose, size * racket, {{impulse, point}}, size, "change of L", expected,
                           body.angular_momentum - before.angular_momentum);
    });
    // A few roundings of float, relative to the momenta and speeds of this size.
    const Real scale = body.mass * size;
    here.expect_near("P", body.linear_momentum, momentum.cast<Real>(), 1e-5 * scale, "kg·m/s");
    here.expect_near("L", body.angular_momentum, spin.cast<Real>(), 1e-5 * scale * size, "kg·m²/s");
    here.expect_near("v", body.linear_velocity, (momentum / body.mass).cast<Real>(), 1e-5 * size,
                     "m/s");
    here.expect_near("ω", body.angular_velocity, w.cast<Real>(), 1e-4, "rad/s");
    here.expect_near("gathered force, which is not an impulse's", body.force, before.force, 0, "N");
    here.expect_near("gathered torque", body.torque, before.torque, 0, "N·m");
    here.expect_near("position", body.pose.position, pose.position, 0, "m");
  }
}

GRADED_TEST(Lab1, ImpulseLeavesImmovableBodiesAlone, 2, "L1.2") {
  Story movable = with_impulse_causes(Story("An impulse changes a dynamic body"));
  movable.given("a dynamic body at rest").when("an impulse of 5 N·s strikes it off centre");
  RigidBody pushed = box(racket);
  apply_impulse(pushed, Vec3(0, 0, 5), Vec3(1, 0, 0));
  require(movable.expect_near("P", pushed.linear_momentum, Vec3(0, 0, 5), 1e-6, "kg·m/s"));
  require(movable.expect_near("L", pushed.angular_momentum, Vec3(0, -5, 0), 1e-6, "kg·m²/s"));

  for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic}) {
    RigidBody body = make_immovable_body(kind, Pose{});
    set_velocity(body, Vec3(1, 0, 0), Vec3(0, 2, 0));
    const RigidBody before = body;
    apply_impulse(body, Vec3(0, 0, 5), Vec3(1, 0, 0));

    Story story("An impulse does not change a body that is not dynamic");
    story
        .given(kind == BodyKind::Static ? "a static body" : "a kinematic body that its owner moves")
        .when("an impulse of 5 N·s strikes it off centre")
        .likely("only a dynamic body has momenta: leave the others before anything is added");
    story.expect_near("P", body.linear_momentum, Vec3::Zero(), 0, "kg·m/s");
    story.expect_near("L", body.angular_momentum, Vec3::Zero(), 0, "kg·m²/s");
    story.expect_near("v", body.linear_velocity, before.linear_velocity, 0, "m/s");
    story.expect_near("ω", body.angular_velocity, before.angular_velocity, 0, "rad/s");
  }
}

}  // namespace
}  // namespace cs550::test
