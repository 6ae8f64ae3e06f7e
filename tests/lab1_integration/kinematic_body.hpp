#pragma once
/// @file kinematic_body.hpp
/// A kinematic body: its velocities are given and constant, for any method.

#include "helpers/random.hpp"
#include "helpers/story.hpp"
#include "lab1_integration/free_body.hpp"

namespace cs550::test {

/// A kinematic body that moves by (0, 2, 0) m in a second and turns at 3 rad/s about a random axis.
struct KinematicBody {
  explicit KinematicBody(std::uint32_t seed) : random(seed) {
    w = 3 * random.unit_vector();
    start = random.orientation();
    body = make_immovable_body(BodyKind::Kinematic, Pose{Vec3(1, 0, 0), start});
    body.linear_velocity = Vec3(0, 2, 0);
    body.angular_velocity = w;
  }

  /// @param angle by which it should have turned in that second (rad)
  void expect_after_a_second(Story& story, double angle) const {
    const Eigen::Quaterniond exact =
        Eigen::AngleAxisd(angle, w.cast<double>().normalized()) * start.cast<double>().normalized();
    story.expect_at_most("orientation off by", orientation_error(body, exact), 1e-5, "rad");
    story.expect_near("position", body.pose.position, Vec3(1, 2, 0), 1e-5, "m");
  }

  Random random;
  Vec3 w;
  Quat start;
  RigidBody body;
};

}  // namespace cs550::test
