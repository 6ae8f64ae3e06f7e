// Random bodies in random poses: all numbers stay finite, and no stage violates its postconditions.

#include <gtest/gtest.h>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

/// Boxes, prisms, tetrahedra, hulls and a plate.
std::vector<ShapePtr> some_shapes() {
  Random random(51);
  std::vector<ShapePtr> shapes;
  for (int i = 0; i < 60; ++i) {
    const Vec3 size = Vec3::Constant(Real(0.25)) + random.point_in_box(Vec3::Constant(Real(0.2)));
    const int corners = random.integer(4, 32);
    switch (i % 4) {
      case 0:
        shapes.push_back(box_shape(size));
        break;
      case 1:
        shapes.push_back(shape_of(prism_soup(3 + corners / 4, size.x(), size.y())));
        break;
      case 2:
        shapes.push_back(shape_of(tetrahedron_soup(2 * size.x())));
        break;
      default:
        shapes.push_back(random_hull(random, corners, size));
    }
  }
  shapes.push_back(box_shape({Real(0.5), Real(0.5), Real(0.02)}));
  return shapes;
}

/// The same shapes and a needle of 1 : 50.
std::vector<ShapePtr> shapes_with_a_needle() {
  std::vector<ShapePtr> shapes = some_shapes();
  shapes.push_back(box_shape({Real(0.02), Real(0.02), 1}));
  return shapes;
}

World random_scene(Random& random, const std::vector<ShapePtr>& shapes) {
  World world;
  world.settings().check_stages = true;
  if (random.integer(0, 9) != 0) world.add_body(floor_body());
  const int count = random.integer(2, 20);
  for (int i = 0; i < count; ++i) {
    const int shape = random.integer(0, static_cast<int>(shapes.size()) - 1);
    const Vec3 place = random.point_in_box({1, 1, 1}) + Vec3(0, 0, Real(1.5));
    BodyDef def = body_at(shapes[shape], place);
    def.pose.orientation = random.orientation();
    const Real speed = random.real(0, 5);
    def.linear_velocity = speed * random.unit_vector();
    const Real spin = random.real(0, 10);
    def.angular_velocity = spin * random.unit_vector();
    def.friction = random.real(0, 1);
    def.restitution = random.integer(0, 2) == 0 ? random.real(0, 1) : 0;
    def.density = random.integer(0, 4) == 0 ? 10000 : 1000;
    world.add_body(def);
  }
  return world;
}

void expect_sane(const World& world) {
  ASSERT_TRUE(world.problems().empty()) << world.problems()[0].message;
  for (const RigidBody& body : world.bodies()) {
    ASSERT_TRUE(body.pose.position.allFinite());
    ASSERT_NEAR(body.pose.orientation.norm(), 1, 1e-4);
    ASSERT_TRUE(body.linear_momentum.allFinite() && body.angular_momentum.allFinite());
    // 5 m/s initially, 39 m/s from falling for 4 s, and the speeds of bodies that begin inside each
    // other. 100 m/s would be an explosion.
    ASSERT_LT(body.linear_velocity.norm(), 100);
  }
}

/// Runs scenes for four seconds each. Bodies may begin inside each other.
void run_scenes(const std::vector<ShapePtr>& shapes, int count, std::uint32_t seed,
                bool temporal_coherence = false) {
  Random random(seed);
  long touching = 0;
  for (int scene = 0; scene < count; ++scene) {
    World world = random_scene(random, shapes);
    world.settings().temporal_coherence = temporal_coherence;
    for (int step = 0; step < 240; ++step) {
      SCOPED_TRACE(testing::Message()
                   << "seed " << seed << ", scene " << scene << ", step " << step);
      world.step(step_length);
      expect_sane(world);
      if (testing::Test::HasFatalFailure()) return;
    }
    touching += world.stats().contacts;
  }
  EXPECT_GT(touching, count) << "the bodies hardly met";
}

TEST(RandomScenes, TwentyStayFinite) { run_scenes(some_shapes(), 20, 52); }
TEST(RandomScenes, TwentyCoherentOnesStayFinite) { run_scenes(some_shapes(), 20, 55, true); }
TEST(RandomScenes, AThousandStayFiniteLong) { run_scenes(some_shapes(), 1000, 53); }
TEST(RandomScenes, NeedlesStayFiniteLong) { run_scenes(shapes_with_a_needle(), 100, 53); }
TEST(RandomScenes, TenThousandStayFiniteSoak) { run_scenes(some_shapes(), 10000, 54); }

}  // namespace
}  // namespace cs550
