#include <cs550/graded_test.hpp>

#include "solver_world.hpp"

namespace cs550::test {
namespace {

/// Speeds along x of equal cubes in a row without friction. The first arrives at 2 m/s.
std::vector<double> cradle(int count, Real gap, Story& story) {
  World world = checked_world();
  add_floor(world, 20, 0);
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  std::vector<BodyId> cubes;
  for (int k = 0; k < count; ++k) {
    BodyDef def = body_at(cube, {(1 + gap) * static_cast<Real>(k - 1), 0, Real(0.5)});
    def.friction = 0;
    def.restitution = 1;
    if (k == 0) def.pose.position.x() = Real(-1.25);
    if (k == 0) def.linear_velocity.x() = 2;
    cubes.push_back(world.add_body(def));
  }
  run_world(world, story, 1);
  std::vector<double> speeds;
  speeds.reserve(cubes.size());
  for (const BodyId cube_id : cubes) {
    speeds.push_back(static_cast<double>(world.body(cube_id).linear_velocity.x()));
  }
  return speeds;
}

GRADED_TEST(Lab7, CradlePassesTheBlowOn, 1, "L7.9") {
  Story story("in a row with gaps the last cube leaves with the speed of the first");
  // More than a cube travels in two steps, so that each impact ends before the next begins.
  story.given("5 equal cubes, gaps 0.1 m, e = 1, no friction, the first at 2 m/s").when("1 s");
  story.likely("each impact is −e·v_n⁰ of its own constraint")
      .likely(
          "in a sweep the constraints under a cube that bounces must hold it: their target is 0")
      .likely("whether anything bounces is decided once; restitution_iterations ends the sweeps");
  const std::vector<double> apart = cradle(5, Real(0.1), story);
  for (std::size_t k = 0; k < 5; ++k) {
    story.expect_near("speed of cube " + std::to_string(k + 1), apart[k], k == 4 ? 2 : 0, 0.04,
                      "m/s");
  }
  Story touching("in a touching row all impacts are one: −⅓, ⅔, ⅔ of the speed");
  touching.given("3 equal cubes, the last two touching, e = 1, no friction, the first at 2 m/s");
  touching.likely(
      "v_n⁰ of the second constraint is 0: it is not driven to bounce, but held at v_n ≥ 0");
  const std::vector<double> together = cradle(3, 0, touching);
  const double expected[] = {-2.0 / 3, 4.0 / 3, 4.0 / 3};
  for (std::size_t k = 0; k < 3; ++k) {
    touching.expect_near("speed of cube " + std::to_string(k + 1), together[k], expected[k], 0.04,
                         "m/s");
  }
}

}  // namespace
}  // namespace cs550::test
