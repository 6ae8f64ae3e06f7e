#pragma once
/// @file convergence.hpp
/// The order of an integration method, measured by halving the step.

#include "helpers/story.hpp"
#include "lab1_integration/free_body.hpp"
#include "lab1_integration/pictures.hpp"

namespace cs550::test {

/// Turns the racket freely for a second with 30 to 240 steps. The slope of the error must be the
/// order within 0.1: the next order in h is still visible at 30 Hz.
/// @param picture_rate steps per second in the picture of a failure
inline void expect_order(Story story, RotationMethod method, double order, int picture_rate) {
  const Vec3 spin(Real(0.5), 5, Real(0.5));
  story.given("half-extents", racket, "m").given("body ω", spin, "rad/s");
  story.when("orientation after 1 s against a Runge–Kutta solution in double precision");
  const RigidBody start = spinning_box(racket, spin);
  story.picture([&] { return tumbling_picture(start, 1, picture_rate, method); });
  FreeRotation exact(start);
  exact.advance(1);
  double coarser = 0;
  for (const int rate : {30, 60, 120, 240}) {
    RigidBody body = start;
    for (int i = 0; i < rate; ++i) turn(body, Real(1) / static_cast<Real>(rate), method);
    const double error = orientation_error(body, exact.orientation());
    Story here = story;
    here.given("rate", rate, "Hz").given("error", error, "rad");
    if (coarser > 0) {
      here.expect_near("slope log₂(error/error)", std::log2(coarser / error), order, 0.1);
    }
    coarser = error;
  }
}

}  // namespace cs550::test
