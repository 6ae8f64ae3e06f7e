// The camera at the ends of its ranges.
#include "pages/base/camera.hpp"

#include <gtest/gtest.h>

namespace cs550::test {
namespace {

using namespace pages;

Vec3 right_of(const Camera& camera) {
  return Projection(camera, {300, 300}, {0, 0, 300, 300}).right();
}

TEST(Camera, SeenFromAboveOrBelowTurnsWithoutAJump) {
  for (const Real pitch : {pi / 2, -pi / 2}) {
    Camera camera = seen_from(Real(0.7), pitch);
    const Vec3 before = right_of(camera);
    camera.orbit(0, 0);
    EXPECT_LT((right_of(camera) - before).norm(), 1e-6) << pitch;
  }
}

TEST(Camera, ZoomsFromAnyDistance) {
  Camera camera;
  camera.distance = 2e4F;
  camera.zoom(Real(1.1));
  EXPECT_NEAR(camera.distance, 2.2e4, 1);
  for (const Real distance : {Real(3e7), Real(1e-4)}) {
    camera.distance = distance;
    camera.zoom(1);
    EXPECT_EQ(camera.distance, distance);
  }
  camera.distance = 1e7F;
  camera.zoom(2);
  EXPECT_EQ(camera.distance, 1e7F);
}

}  // namespace
}  // namespace cs550::test
