#include <gtest/gtest.h>

#include "cs550/clipping.hpp"
#include "cs550/primitives.hpp"

using namespace cs550;

ClipPolygon unit_square() {
  ClipPolygon square;
  const Vec3 corners[]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (Index i = 0; i < 4; ++i) {
    const auto edge = [](Index e) { return ClipEdge{ClipEdge::Source::Incident, e}; };
    square.push_back({corners[i], edge((i + 3) % 4), edge(i)});
  }
  return square;
}

TEST(Clip, CutsASquareInHalf) {
  const ClipPolygon half = clip_polygon(unit_square(), {Vec3(1, 0, 0), Real(0.25)});
  ASSERT_EQ(half.size(), 4);
  for (const ClipVertex& corner : half) EXPECT_LE(corner.point.x(), 0.25 + 1e-6);
}

TEST(Clip, KeepsWhatIsInsideAndDropsWhatIsOutside) {
  EXPECT_EQ(clip_polygon(unit_square(), {Vec3(1, 0, 0), 2}).size(), 4);
  EXPECT_EQ(clip_polygon(unit_square(), {Vec3(1, 0, 0), -1}).size(), 0);
}

TEST(Manifold, OfStackedBoxesHasFourCornersOfTheSmallerOne) {
  const auto box = [](Real half) {
    const TriangleSoup soup = box_soup(Vec3(half, half, half));
    return make_shape(soup.vertices, soup.triangles).shape;
  };
  const ShapePtr large = box(2);
  const ShapePtr small = box(1);
  Pose above;
  above.position = Vec3(0, 0, Real(2.9));
  const PosedShape a{large.get(), {}};
  const PosedShape b{small.get(), above};
  const Manifold manifold = build_manifold(a, b, find_separating_axis(a, b, {}, 1), 1);
  ASSERT_EQ(manifold.points.size(), 4);
  EXPECT_NEAR(manifold.normal.z(), 1, 1e-5);
  for (const ContactPoint& point : manifold.points) {
    EXPECT_NEAR(point.separation, -0.1, 1e-5);
    EXPECT_NEAR(std::abs(point.anchor_b.x()), 1, 1e-5);
    EXPECT_NEAR(point.anchor_a.z(), 2, 1e-5);
  }
}
