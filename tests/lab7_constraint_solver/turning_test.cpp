#include <cs550/graded_test.hpp>

#include "solver_world.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab7, BoxesTipWhereTheirWeightLeavesTheBase, 1, "L7.8") {
  const Vec3 half(Real(0.25), Real(0.25), Real(0.5));
  const double limit = std::atan(0.5);
  for (const double excess : {-0.02, 0.02}) {
    for (const double azimuth : {0.0, static_cast<double>(pi) / 2}) {
      Story story("on a rough slope a box tips where tan θ exceeds its width/height, not before");
      story.given("width 0.5 m, height 1 m, μ = 1.5").given("tan θ", std::tan(limit + excess));
      story.given("direction of the slope", azimuth, "rad").when("2 s");
      story.likely("the corners uphill may be released: their λ_n goes down to 0, never below");
      World world = checked_world();
      world.settings().gravity = gravity_on_slope(limit + excess, azimuth);
      add_floor(world, 20, Real(1.5));
      BodyDef def = body_at(box_shape(half), {0, 0, half.z()});
      def.friction = Real(1.5);
      const BodyId box = world.add_body(def);
      run_world(world, story, 2);
      const Vec3 up = world.body(box).pose.rotate(Vec3::UnitZ());
      if (excess < 0) {
        story.expect_at_least("cosine of the box's tilt", static_cast<double>(up.z()), 0.9999);
      } else {
        story.expect_at_most("cosine of the box's tilt", static_cast<double>(up.z()), 0.5);
      }
    }
  }
}

GRADED_TEST(Lab7, FrictionStopsASpinningBox, 1, "L7.8") {
  Story story("a box that spins on the floor is stopped by the torque μ·m·g·r of its corners");
  const double spin = 8;
  const double half = 0.5;
  // Four corners, each with a quarter of the weight at r = half·√2: I·ω̇ = −μ·m·g·r, I = m·(2·half)²/6.
  const double deceleration = 0.4 * gravity * half * std::sqrt(2.0) / (4 * half * half / 6);
  story.given("a cube of 1 m, μ = 0.4").given("ω₀", spin, "rad/s");
  story.likely("friction at a corner acts along its own slip, with the lever r_B");
  World world = checked_world();
  add_floor(world, 20, 1);
  BodyDef def = body_at(box_shape(Vec3::Constant(static_cast<Real>(half))), {0, 0, Real(0.5)});
  def.friction = Real(0.16);
  def.angular_velocity.z() = static_cast<Real>(spin);
  const BodyId box = world.add_body(def);
  run_world(world, story, 0.25);
  const double expected = spin - 0.25 * deceleration;
  story.expect_near("ω after 0.25 s", static_cast<double>(world.body(box).angular_velocity.z()),
                    expected, 0.02 * spin, "rad/s");
  run_world(world, story, 2);
  story.expect_near("ω in the end", world.body(box).angular_velocity, Vec3::Zero(), 1e-3, "rad/s");
  const Vec3 moved = world.body(box).pose.position - def.pose.position;
  story.expect_near("distance that the centre has moved", moved, Vec3::Zero(), 5e-3, "m");
}

}  // namespace
}  // namespace cs550::test
