#include <cs550/graded_test.hpp>

#include <algorithm>

#include "solver_world.hpp"

namespace cs550::test {
namespace {

constexpr int heights = 64;

/// The height of boxes after their first bounce, relative to the height of their fall.
std::vector<double> apexes(Real restitution, Story& story) {
  World world = checked_world();
  add_floor(world, 20, Real(0.5));
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  std::vector<BodyId> boxes;
  std::vector<double> fallen;
  for (int k = 0; k < heights; ++k) {
    const Real height = 5 + static_cast<Real>(k) * Real(0.005);
    const int row = k / 8;
    const Vec3 place(static_cast<Real>(4 * (k % 8) - 14), static_cast<Real>(4 * row - 14), 0);
    BodyDef def = body_at(cube, place + Vec3(0, 0, Real(0.5) + height));
    def.restitution = restitution;
    boxes.push_back(world.add_body(def));
    fallen.push_back(static_cast<double>(height));
  }
  std::vector<double> highest(heights, 0);
  std::vector<char> bounced(heights, 0);
  const double fall = std::sqrt(2 * 5.4 / gravity);
  const double rise = static_cast<double>(restitution) * fall;
  while (world.time() < fall + 1.1 * rise + 0.1) {
    step_world(world, story);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const RigidBody& body = world.body(boxes[k]);
      if (body.linear_velocity.z() > 0) bounced[k] = 1;
      const double height = static_cast<double>(body.pose.position.z()) - 0.5;
      if (bounced[k]) highest[k] = std::max(highest[k], height);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) highest[k] /= fallen[k];
  return highest;
}

GRADED_TEST(Lab7, BouncesReachTheSquareOfRestitution, 1, "L7.9") {
  for (const Real e : {Real(1), Real(0.8), Real(0.5)}) {
    Story story("a box dropped from h bounces to e²·h");
    story.given("64 cubes that fall 5 m + k·5 mm").given("e", e);
    story.likely("v_n⁰ is measured before gravity and warm start, by the world")
        .likely("push and bounce are not added")
        .likely("an impact is handled once: in the substep in which λ_n first becomes positive")
        .likely("whether anything bounces is decided once; restitution_iterations ends the sweeps");
    const std::vector<double> reached = apexes(e, story);
    double mean = 0;
    double worst = 0;
    const double square = static_cast<double>(e) * static_cast<double>(e);
    for (const double apex : reached) {
      mean += apex / square / heights;
      worst = std::max(worst, std::abs(apex / square - 1));
    }
    story.expect_near("mean apex/(e²·h)", mean, 1, 0.02);
    story.expect_at_most("largest |apex/(e²·h) − 1|", worst, 0.03);
  }
}

}  // namespace
}  // namespace cs550::test
