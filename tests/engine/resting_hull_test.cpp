// Hulls of many small faces on a floor: which of their points touch it.

#include <gtest/gtest.h>

#include "cs550/clipping.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;

Real deepest(const Manifold& manifold) {
  Real separation = HUGE_VALF;
  for (const ContactPoint& point : manifold.points) {
    separation = std::min(separation, point.separation);
  }
  return separation;
}

/// The distance of the lowest vertex from the floor y = 0.
double lowest(const PosedShape& body) {
  double y = HUGE_VAL;
  for (const Vec3& vertex : body.mesh().vertices) {
    y = std::min(y, double{body.pose.to_world(vertex).y()});
  }
  return y;
}

// The most anti-parallel of all faces often lacks the lowest vertex. Until the points that it left were
// preference × radius too high, 2.5 mm here, the manifold was as deep as they were.
TEST(RestingHull, TouchesTheFloorWithItsLowestVertex) {
  Random random(20261127);
  SCOPED_TRACE(::testing::Message() << "seed " << random.seed());
  const ShapePtr floor = box_shape({5, 1, 5});
  const PosedShape ground{floor.get(), {Vec3(0, -1, 0), Quat::Identity()}};
  for (int i = 0; i < 500; ++i) {
    const ShapePtr hull = random_hull(random, 44, Vec3::Constant(Real(0.5)));
    PosedShape body{hull.get(), {Vec3::Zero(), random.orientation()}};
    body.pose.position.y() = static_cast<Real>(-lowest(body)) - Real(0.001);
    const SeparatingAxis axis = find_separating_axis(ground, body, {}, 0);
    const Manifold manifold = build_manifold(ground, body, axis, Real(0.01));
    // Rounding of positions of 1 m.
    ASSERT_NEAR(deepest(manifold), lowest(body), 1e-6) << "hull " << i;
  }
}

}  // namespace
}  // namespace cs550
