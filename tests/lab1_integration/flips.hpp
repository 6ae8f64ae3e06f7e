#pragma once
/// @file flips.hpp
/// The Dzhanibekov effect, detected by sign changes of the body-frame ω_y.

#include <vector>

#include "lab1_integration/free_body.hpp"

namespace cs550::test {

/// The times at which ω_y of a free body changes sign, by implicit midpoint at 60 Hz (s).
inline std::vector<double> flip_times(RigidBody body, double duration) {
  constexpr double h = 1.0 / 60;
  std::vector<double> times;
  double before = body.pose.unrotate(body.angular_velocity).y();
  for (int i = 0; i * h < duration; ++i) {
    turn(body, static_cast<Real>(h), RotationMethod::ImplicitMidpoint);
    const double now = body.pose.unrotate(body.angular_velocity).y();
    if (before * now < 0) times.push_back((i + before / (before - now)) * h);
    before = now;
  }
  return times;
}

}  // namespace cs550::test
