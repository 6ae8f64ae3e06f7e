#pragma once
/// @file solver_world.hpp
/// Complete worlds for tests of the solver: boxes, a floor, and steps that end the test at the first
/// missing or failed stage.

#include "cs550/world.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

inline constexpr Real step_length = Real(1) / 60;
inline constexpr double gravity = 9.81;

/// A box, without the code of lab 2.
ShapePtr box_shape(const Vec3& half_extents);

inline BodyDef body_at(const ShapePtr& shape, const Vec3& position) {
  BodyDef def;
  def.shape = shape;
  def.pose.position = position;
  return def;
}

inline Quat yaw(Real angle) { return rotation_exp(Vec3(0, 0, angle)); }

/// A world that checks the postconditions of its stages.
inline World checked_world() {
  WorldSettings settings;
  settings.check_stages = true;
  settings.temporal_coherence = false;  // every step has fresh contacts
  return World(settings);
}

/// A static floor whose upper side is the plane z = 0.
inline void add_floor(World& world, Real half_width, Real friction,
                      Real half_thickness = Real(0.5)) {
  BodyDef floor =
      body_at(box_shape({half_width, half_width, half_thickness}), {0, 0, -half_thickness});
  floor.kind = BodyKind::Static;
  floor.friction = friction;
  world.add_body(floor);
}

/// The gravity in the frame of a slope that descends at an angle in the direction of an azimuth, so
/// that the slope can be horizontal.
inline Vec3 gravity_on_slope(double slope, double azimuth) {
  return Vec3(static_cast<Real>(gravity * std::sin(slope) * std::cos(azimuth)),
              static_cast<Real>(gravity * std::sin(slope) * std::sin(azimuth)),
              static_cast<Real>(-gravity * std::cos(slope)));
}

/// Ends the test as if it had called the unwritten step itself.
/// @throws NotImplemented if that is the problem
void throw_if_unwritten(const StageProblem& problem);

/// One step. A violated postcondition ends the test.
/// @throws NotImplemented if a stage is not written yet
inline void step_world(World& world, Story& story) {
  world.step(step_length);
  if (world.problems().empty()) return;
  throw_if_unwritten(world.problems().front());
  require(story.expect_equal("problem in the step", world.problems().front().message,
                             std::string("none")));
}

/// Steps for a time, a whole number of steps (s).
inline void run_world(World& world, Story& story, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(step_length)));
  for (int i = 0; i < steps; ++i) step_world(world, story);
}

}  // namespace cs550::test
