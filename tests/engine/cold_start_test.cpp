// The first guess of impulses: the loads of a tower, compared with the weight above each contact.
#include <gtest/gtest.h>

#include <vector>

#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

constexpr int cubes = 10;

/// Cubes of 1 m above each other, on the floor.
World tower(Real gap) {
  WorldSettings settings;
  // Without passes the impulses stay what they were guessed to be.
  settings.iterations = 0;
  settings.relax_iterations = 0;
  settings.substeps = 1;
  World world(settings);
  world.add_body(floor_body());
  const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
  for (int i = 0; i < cubes; ++i) {
    world.add_body(body_at(cube, {0, 0, Real(0.5) + gap + (1 + gap) * static_cast<Real>(i)}));
  }
  return world;
}

/// Of each contact, from the bottom to the top: the sum of its normal impulses (N·s).
std::vector<double> loads(const World& world) {
  std::vector<double> loads(cubes);
  for (const Contact& contact : world.contacts()) {
    for (const ContactPoint& point : contact.manifold.points) {
      loads[static_cast<std::size_t>(contact.body_b - 1)] +=
          static_cast<double>(point.normal_impulse);
    }
  }
  return loads;
}

// In a step of h each contact passes on m·g·h of every cube above it. The sweeps end at 1e-5 of the speed of fall,
// and the errors of ten loads add up: a thousandth is ten times that.
TEST(ColdStart, GivesATowerTheLoadsOfItsWeight) {
  World world = tower(0);
  const double weight =
      static_cast<double>(world.bodies()[1].mass) * 9.81 * static_cast<double>(step_length);
  world.step(step_length);
  const std::vector<double> found = loads(world);
  for (int i = 0; i < cubes; ++i) {
    EXPECT_NEAR(found[static_cast<std::size_t>(i)], (cubes - i) * weight, 1e-3 * cubes * weight)
        << "contact " << i;
  }
}

// In a step of h a body falls by g·h². Ten gaps of a twentieth of that are less than the uppermost cube falls, so
// every contact stops what is left. Gaps of ten times g·h² stay open, whatever the loads.
TEST(ColdStart, GivesNoLoadAcrossAGapThatStaysOpen) {
  const Real fall = Real(9.81) * step_length * step_length;
  World near = tower(fall / 20);
  near.step(step_length);
  for (const double load : loads(near)) EXPECT_GT(load, 0);
  World far = tower(fall * 10);
  far.step(step_length);
  for (const double load : loads(far)) EXPECT_EQ(load, 0);
}

}  // namespace
}  // namespace cs550
