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

/// The orientation in which a hull stands on an edge, one end a little lower than the other.
Quat standing_on(const HalfEdgeMesh& mesh, Index edge, Random& random) {
  const Vec3& left = mesh.face(mesh.edge(edge).face).plane.normal;
  const Vec3& right = mesh.face(mesh.edge(mesh.edge(edge).twin).face).plane.normal;
  const Real share = random.real(0, 1);
  const Vec3 down = (share * left + (1 - share) * right).normalized() +
                    random.real(Real(-0.01), Real(0.01)) * mesh.edge_vector(edge).normalized();
  return Quat::FromTwoVectors(down, Vec3(-Vec3::UnitY()));
}

// The most anti-parallel of all faces may lack the lowest vertex, and have others that are not much higher.
TEST(RestingHull, TouchesTheFloorWithItsLowestVertex) {
  Random random(20261127);
  SCOPED_TRACE(::testing::Message() << "seed " << random.seed());
  const ShapePtr floor = box_shape({5, 1, 5});
  const PosedShape ground{floor.get(), {Vec3(0, -1, 0), Quat::Identity()}};
  for (int i = 0; i < 2000; ++i) {
    const ShapePtr hull = random_hull(random, 44, Vec3::Constant(Real(0.5)));
    const Index edge = random.integer(0, hull->mesh.edge_count() - 1);
    PosedShape body{hull.get(), {Vec3::Zero(), standing_on(hull->mesh, edge, random)}};
    body.pose.position.y() = static_cast<Real>(-lowest(body)) - Real(0.001);
    const SeparatingAxis axis = find_separating_axis(ground, body, {}, 0);
    const Manifold manifold = build_manifold(ground, body, axis, Real(0.01));
    // Rounding of positions of 1 m.
    ASSERT_NEAR(deepest(manifold), lowest(body), 1e-6) << "hull " << i;
  }
}

}  // namespace
}  // namespace cs550
