#pragma once
/// @file first_turn.hpp
/// Checks that a body turns at all. A body that never turns conserves energy and momentum too.

#include "helpers/require.hpp"
#include "helpers/story.hpp"
#include "lab1_integration/free_body.hpp"

namespace cs550::test {

/// Ends the test unless the first step turns the body by about h·|ω|. That ω follows from L in double
/// precision: the body's own is the work of the code under test, and may be 0.
inline void require_first_turn(const Story& story, RigidBody body, Real h, RotationMethod method) {
  const Eigen::Quaterniond before = body.pose.orientation.cast<double>();
  const Eigen::Vector3d w = world_inertia(body).inverse() * body.angular_momentum.cast<double>();
  const double expected = double{h} * w.norm();
  turn(body, h, method);
  Story first = story;
  first.given("first step", h, "s").likely("the orientation changes in every step");
  require(first.expect_near("angle of the first step", orientation_error(body, before), expected,
                            0.2 * expected, "rad"));
}

}  // namespace cs550::test
