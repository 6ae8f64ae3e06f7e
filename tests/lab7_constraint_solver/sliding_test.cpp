#include <cs550/graded_test.hpp>

#include "solver_world.hpp"

namespace cs550::test {
namespace {

const Vec3 cube_half(Real(0.5), Real(0.5), Real(0.5));
const Vec3 long_half(Real(1), Real(0.2), Real(0.2));

/// The position after a time of a box that starts at rest on a slope, modelled by tilted gravity.
struct Slide {
  Vec3 moved;
  Vec3 velocity;
};

Slide slide(const Vec3& half_extents, double slope, double azimuth, double seconds, Story& story) {
  World world = checked_world();
  world.settings().gravity = gravity_on_slope(slope, azimuth);
  add_floor(world, 20, 1);
  BodyDef def = body_at(box_shape(half_extents), {0, 0, half_extents.z()});
  def.friction = Real(0.25);  // That of the pair is √(0.25 · 1) = 0.5.
  def.pose.orientation = yaw(Real(0.3));
  const BodyId box = world.add_body(def);
  run_world(world, story, seconds);
  return {world.body(box).pose.position - def.pose.position, world.body(box).linear_velocity};
}

GRADED_TEST(Lab7, BoxesStickBelowTheAngleOfFriction, 1, "L7.8") {
  const double slope = std::atan(0.5) - 0.02;
  for (const Vec3& half : {cube_half, long_half}) {
    for (int k = 0; k < 12; ++k) {
      const double azimuth = k * static_cast<double>(pi) / 6;
      Story story("below atan μ a box sticks to a slope, whichever way it goes down");
      story.given("half-extents", half, "m").given("μ", 0.5).given("slope", slope, "rad");
      story.given("direction of the slope", azimuth, "rad").when("2 s");
      story
          .likely(
              "friction accumulates: each solve adds to λ_u and λ_v, which the disk then limits")
          .likely("the radius of the disk is μ times the *accumulated* λ_n");
      const Slide end = slide(half, slope, azimuth, 2, story);
      // It sinks and tilts a little into its soft contact before it rests.
      require(story.expect_near("distance moved", end.moved, Vec3::Zero(), 1e-3, "m"));
      require(story.expect_near("velocity", end.velocity, Vec3::Zero(), 1e-3, "m/s"));
    }
  }
}

GRADED_TEST(Lab7, BoxesSlideAlikeInEveryDirection, 1, "L7.8") {
  const double slope = std::atan(0.5) + 0.15;
  const double speed = gravity * (std::sin(slope) - 0.5 * std::cos(slope));
  for (const Vec3& half : {cube_half, long_half}) {
    for (int k = 0; k < 12; ++k) {
      const double azimuth = k * static_cast<double>(pi) / 6;
      Story story("above atan μ a box slides with v = g·(sin θ − μ·cos θ)·t, in every direction");
      story.given("half-extents", half, "m").given("μ", 0.5).given("slope", slope, "rad");
      story.given("direction of the slope", azimuth, "rad").when("1 s");
      story.likely("friction is bounded by a disk, not by a box")
          .likely("sliding friction points against the slip; the 2 × 2 mass turns away from it");
      const Slide end = slide(half, slope, azimuth, 1, story);
      const Vec3 down(static_cast<Real>(std::cos(azimuth)), static_cast<Real>(std::sin(azimuth)),
                      0);
      const Vec3 expected = static_cast<Real>(speed) * down;
      require(story.expect_near("velocity", end.velocity, expected, 0.01 * speed, "m/s"));
    }
  }
}

GRADED_TEST(Lab7, SlidingBoxesStopAfterTheirStoppingDistance, 1, "L7.8") {
  for (const Vec3& half : {cube_half, long_half}) {
    for (const double azimuth : {0.0, 0.5, 2.0}) {
      Story story("a box that slides at v₀ stops after v₀²/(2·μ·g)");
      story.given("half-extents", half, "m").given("μ", 0.4).given("v₀", 3, "m/s");
      story.given("direction", azimuth, "rad");
      story.likely("friction works against the slip with μ·λ_n, until it has stopped the slip");
      World world = checked_world();
      add_floor(world, 20, 1);
      BodyDef def = body_at(box_shape(half), {0, 0, half.z()});
      def.friction = Real(0.16);
      def.linear_velocity =
          3 * Vec3(static_cast<Real>(std::cos(azimuth)), static_cast<Real>(std::sin(azimuth)), 0);
      const BodyId box = world.add_body(def);
      run_world(world, story, 1.5);
      const double distance = 9 / (2 * 0.4 * gravity);
      const Vec3 expected = static_cast<Real>(distance / 3) * def.linear_velocity;
      // Half of a substep of 1/360 s at 3 m/s: 0.4 % of the distance, and as much for the tilt.
      require(story.expect_near("distance moved", world.body(box).pose.position - def.pose.position,
                                expected, 0.01 * distance, "m"));
      require(story.expect_near("velocity in the end", world.body(box).linear_velocity,
                                Vec3::Zero(), 1e-3, "m/s"));
    }
  }
}

}  // namespace
}  // namespace cs550::test
