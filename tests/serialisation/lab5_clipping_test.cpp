#include <gtest/gtest.h>

#include <cmath>

#include "cs550/clipping.hpp"
#include "helpers/random.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

ClipPolygon triangle() {
  ClipPolygon corners;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)}) {
    const Index edge = corners.size();
    corners.push_back(
        {corner, {ClipEdge::Source::Incident, edge}, {ClipEdge::Source::Reference, edge + 1}});
  }
  return corners;
}

/// More points than a manifold can keep.
std::vector<ContactPoint> nine_points() {
  std::vector<ContactPoint> points;
  Random random(31);
  for (Index i = 0; i < 9; ++i) {
    ContactPoint& point = points.emplace_back();
    point.anchor_a = random.point_in_box({1, 1, 0.01F});
    point.anchor_b = random.point_in_box({1, 1, 0.01F});
    point.separation = random.real(-0.1F, 0);
    point.feature = {FeatureId::Kind::CrossingOnA, i, 2 * i};
    point.normal_impulse = random.real(0, 1);
    point.tangent_impulse = {0.5F, -0.5F};
  }
  return points;
}

TEST(Serialisation, Lab5IsCalledAcrossAWire) {
  const PosedShape& a = two_bodies().a;
  const PosedShape& b = two_bodies().b;
  const SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
  ASSERT_TRUE(axis.edges) << "an edge manifold needs a pair of edges";
  EXPECT_SAME_ACROSS_WIRE(clip_polygon, triangle(), Plane{Vec3::UnitX(), 1},
                          {ClipEdge::Source::Reference, 7});
  EXPECT_SAME_ACROSS_WIRE(find_incident_face, b, axis.face_a.vertex, axis.axis);
  SeparatingAxis face_axis = axis;
  face_axis.feature = AxisFeature::FaceA;
  EXPECT_SAME_ACROSS_WIRE(face_manifold, a, b, face_axis, 0.1F);
  EXPECT_SAME_ACROSS_WIRE(edge_manifold, a, b, axis);
  EXPECT_SAME_ACROSS_WIRE(reduce_manifold, nine_points(), Vec3::UnitZ(), 0.1F);
  EXPECT_SAME_ACROSS_WIRE(build_manifold, a, b, axis, 0.1F);
}

TEST(Serialisation, NoMemberOfLab5IsForgotten) {
  EXPECT_EVERY_WORD_SENT(ClipEdge);
  EXPECT_EVERY_WORD_SENT(ClipVertex);
  EXPECT_EVERY_WORD_SENT(FeatureId);
  EXPECT_EVERY_WORD_SENT(ContactPoint);
}

}  // namespace
}  // namespace cs550::test
