// Prefetching: it is worth its time in large worlds only, and changes no bit of the state.

#include "engine/pairs/query_prefetch.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr int bodies = 800;

/// Cubes of 1 m, all with one shape or each with its own.
std::vector<ShapePtr> cubes(bool shared) {
  std::vector<ShapePtr> shapes(bodies, box_shape(Vec3::Constant(Real(0.5))));
  if (shared) return shapes;
  for (ShapePtr& shape : shapes) shape = box_shape(Vec3::Constant(Real(0.5)));
  return shapes;
}

/// The same cubes, where `count` shapes take turns.
std::vector<ShapePtr> cubes_of_shapes(std::size_t count) {
  std::vector<ShapePtr> shapes = cubes(false);
  for (std::size_t i = count; i < shapes.size(); ++i) shapes[i] = shapes[i - count];
  return shapes;
}

WorldState state_with(const std::vector<ShapePtr>& shapes) {
  WorldState state;
  for (const ShapePtr& shape : shapes) state.definitions.push_back(body_at(shape, Vec3::Zero()));
  return state;
}

/// Pairs of cubes that fall and tumble onto each other.
World falling_pairs(const std::vector<ShapePtr>& shapes) {
  Random random(91);
  World world;
  world.add_body(floor_body(100));
  for (int i = 0; i < bodies; ++i) {
    const Real x = static_cast<Real>(i / 2 % 20) * 4;
    const Real y = static_cast<Real>(i / 40) * 4;
    const Real z = i % 2 == 0 ? 1 : Real(2.3);
    BodyDef def = body_at(shapes[static_cast<std::size_t>(i)], {x, y, z});
    def.pose.orientation = random.orientation();
    world.add_body(def);
  }
  return world;
}

TEST(QueryPrefetch, PaysIfManyBodiesHaveShapesOfTheirOwn) {
  EXPECT_TRUE(pays_to_prefetch(state_with(cubes(false))));
  EXPECT_FALSE(pays_to_prefetch(state_with(cubes(true))));
  EXPECT_FALSE(pays_to_prefetch(state_with(cubes_of_shapes(64))));
  EXPECT_FALSE(pays_to_prefetch(state_with(cubes_of_shapes(600))));
  EXPECT_TRUE(pays_to_prefetch(state_with(cubes_of_shapes(780))));
  EXPECT_FALSE(pays_to_prefetch(state_with({})));
}

TEST(QueryPrefetch, ChangesNoBit) {
  World with = falling_pairs(cubes(false));
  World without = falling_pairs(cubes(true));
  for (int step = 0; step < 90; ++step) {
    for (World* world : {&with, &without}) {
      if (step == 60) world->remove_body(world->id_at(7));
      world->step(step_length);
    }
    ASSERT_EQ(with.state_hash(), without.state_hash()) << "step " << step;
  }
  EXPECT_GT(with.stats().contacts, bodies / 2) << "too little touches to test";
}

}  // namespace
}  // namespace cs550
