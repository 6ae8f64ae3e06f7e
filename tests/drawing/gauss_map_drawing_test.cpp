// The Gauss map: a point on the unit sphere for each face, a great-circle arc for each edge.

#include "drawing/gauss_map_drawing.hpp"

#include <gtest/gtest.h>

#include "drawing/minkowski_drawing.hpp"
#include "helpers/fixtures.hpp"

namespace cs550::drawing {
namespace {

using test::fixture_shape;

const Pose turned = {{3, -2, 1}, rotation_exp({Real(0.3), Real(-0.7), Real(1.1)})};

TEST(GaussMapDrawing, ACubeHasSixPointsAndTwelveArcs) {
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape body{cube.get(), turned};
  EXPECT_EQ(gauss_arcs(body).size(), 12U);
  EXPECT_EQ(draw_gauss_map(body, Role::BodyA).points.size(), 6U);
  // A quarter turn each, in pieces of at most 3°.
  EXPECT_EQ(draw_gauss_map(body, Role::BodyA).lines.size(), 12U * 30U);
}

TEST(GaussMapDrawing, EveryArcLiesOnTheUnitSphereAndInOnePlane) {
  for (const char* name : {"cube", "dodecahedron", "sliver", "needle", "hull32"}) {
    const ShapePtr shape = fixture_shape(name);
    for (const GaussArc& arc : gauss_arcs({shape.get(), turned})) {
      const Vec3 pole = arc.from.cross(arc.to);
      const std::vector<Vec3> points = arc_points(arc.from, arc.to);
      EXPECT_LT((points.front() - arc.from).norm(), 1e-5F) << name;
      EXPECT_LT((points.back() - arc.to).norm(), 1e-5F) << name;
      for (const Vec3& point : points) {
        EXPECT_NEAR(point.norm(), 1, 1e-5) << name;
        EXPECT_NEAR(point.dot(pole), 0, 1e-5) << name;
      }
      for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT((points[i] - points[i - 1]).norm(), 0.06F) << name;
      }
    }
  }
}

TEST(GaussMapDrawing, TheNegatedMapIsTheOppositeOne) {
  const ShapePtr prism = fixture_shape("prism6");
  const std::vector<GaussArc> arcs = gauss_arcs({prism.get(), turned});
  const std::vector<GaussArc> negated = gauss_arcs({prism.get(), turned}, true);
  ASSERT_EQ(arcs.size(), negated.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    EXPECT_EQ(arcs[i].from, -negated[i].from);
    EXPECT_EQ(arcs[i].to, -negated[i].to);
  }
}

TEST(GaussMapDrawing, FeaturesThatDoNotExistAreNoted) {
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape body{cube.get(), {}};
  SeparatingAxis axis;
  axis.feature = AxisFeature::FaceA;
  axis.axis = Vec3::UnitX();
  axis.face_a = {77, -3, 0};
  EXPECT_EQ(draw_axis(body, body, axis).notes.size(), 2U);
  axis.feature = AxisFeature::Edges;
  axis.edges = {99, -1, Vec3::UnitX(), 0};
  EXPECT_EQ(draw_axis(body, body, axis).notes.size(), 3U);
  EXPECT_TRUE(draw_gauss_maps(body, body, {}, axis).notes.empty());
}

TEST(MinkowskiDrawing, TwoAlignedCubesMakeACubeOfTwiceTheSize) {
  const ShapePtr cube = fixture_shape("cube");
  const Drawing drawing = draw_minkowski_difference({cube.get(), {}}, {cube.get(), {}});
  EXPECT_EQ(drawing.polygons.size(), 6U);
  for (const Polygon& face : drawing.polygons) {
    EXPECT_EQ(face.corners.size(), 4U);
    for (const Vec3& corner : face.corners) EXPECT_NEAR(corner.cwiseAbs().minCoeff(), 1, 1e-6);
  }
}

TEST(MinkowskiDrawing, HoldsTheOriginWhileTheBodiesOverlap) {
  const ShapePtr cube = fixture_shape("cube");
  const auto words = [&](Real x) {
    const PosedShape b{cube.get(), {{x, 0, 0}, rotation_exp({Real(0.2), Real(0.3), Real(0.4)})}};
    return draw_minkowski_difference({cube.get(), {}}, b).alt_text;
  };
  EXPECT_NE(words(Real(0.9)).find("inside"), std::string::npos);
  EXPECT_NE(words(Real(1.8)).find("outside"), std::string::npos);
}

TEST(MinkowskiDrawing, OfBodiesThatAreNowhereIsEmpty) {
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape nowhere{cube.get(), {Vec3::Constant(NAN), Quat::Identity()}};
  EXPECT_TRUE(draw_minkowski_difference({cube.get(), {}}, nowhere).polygons.empty());
}

TEST(MinkowskiDrawing, IsClosed) {
  // The area vectors of a closed surface sum to zero.
  const ShapePtr a = fixture_shape("cube");
  const ShapePtr b = fixture_shape("prism6");
  const Drawing drawing = draw_minkowski_difference({a.get(), {}}, {b.get(), turned});
  Vec3 area = Vec3::Zero();
  Real total = 0;
  for (const Polygon& face : drawing.polygons) {
    Vec3 twice = Vec3::Zero();
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      twice += face.corners[i].cross(face.corners[(i + 1) % face.corners.size()]);
    }
    area += twice;
    total += twice.norm();
  }
  EXPECT_LT(area.norm(), 1e-4F * total);
}

}  // namespace
}  // namespace cs550::drawing
