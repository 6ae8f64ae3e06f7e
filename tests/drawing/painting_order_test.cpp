// Nearer elements cover farther ones, and hidden lines end at the edge of the face that hides them.

#include "drawing/painting_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cs550::drawing {
namespace {

using Kind = BrushStroke::Kind;

/// A square of side 2 about the z axis, facing up.
Polygon square(Real z) {
  return {{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, Role::BodyA, 1};
}

/// A view of 200 by 200 pixels that shows −2 to 2 from above.
FittedView from_above(Real field_of_view = 0) {
  View view = view_from_above();
  view.frame = {{-2, -2, -2}, {2, 2, 2}};
  view.field_of_view = field_of_view;
  return FittedView(view, {}, {0, 0, 200, 200});
}

std::size_t place_of(const std::vector<BrushStroke>& order, Kind kind, std::size_t index) {
  const auto is_it = [&](const BrushStroke& s) { return s.kind == kind && s.index == index; };
  return std::find_if(order.begin(), order.end(), is_it) - order.begin();
}

TEST(PaintingOrder, PaintsTheFartherPolygonFirst) {
  Drawing drawing;
  drawing.polygons = {square(1), square(-1), square(0)};
  const std::vector<BrushStroke> order = painting_order(drawing, from_above());
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[0].index, 1U);
  EXPECT_EQ(order[1].index, 2U);
  EXPECT_EQ(order[2].index, 0U);
}

TEST(PaintingOrder, ALargeFloorLiesUnderASmallBoxOnIt) {
  // The middle of the floor is nearer to the eye than the lid of the box, so comparing middles
  // would be wrong.
  Drawing drawing;
  drawing.polygons.push_back({{{-9, 9, 0}, {-9, -9, 0}, {1, -9, 0}, {1, 9, 0}}, Role::Faint, 1});
  drawing.polygons.push_back(
      {{{-9, -1, 0.5F}, {-8, -1, 0.5F}, {-8, 1, 0.5F}, {-9, 1, 0.5F}}, Role::BodyA, 1});
  View view;
  view.toward_eye = {1, 0, 1};
  const FittedView fitted(view, outline_positions(drawing, view), {0, 0, 400, 400});
  const std::vector<BrushStroke> order = painting_order(drawing, fitted);
  EXPECT_LT(place_of(order, Kind::Polygon, 0), place_of(order, Kind::Polygon, 1));
}

TEST(PaintingOrder, CutsALineWhereAFaceHidesIt) {
  Drawing drawing;
  drawing.polygons = {square(1)};
  drawing.lines = {{{-2, 0, 0}, {2, 0, 0}, {}}};
  const std::vector<BrushStroke> order = painting_order(drawing, from_above());
  // Hidden between a quarter and three quarters of its length.
  ASSERT_EQ(order.size(), 4U);
  EXPECT_EQ(order[0].kind, Kind::Line);
  EXPECT_NEAR(order[0].from, 0.25, 1e-6);
  EXPECT_NEAR(order[0].to, 0.75, 1e-6);
  EXPECT_EQ(order[1].kind, Kind::Polygon);
  EXPECT_NEAR(order[2].to, 0.25, 1e-6);
  EXPECT_NEAR(order[3].from, 0.75, 1e-6);
}

TEST(PaintingOrder, CutsALineWhereItPiercesAFace) {
  for (const Real field_of_view : {Real(0), Real(0.5)}) {
    Drawing drawing;
    drawing.polygons = {square(0)};
    drawing.lines = {{{-0.5F, 0, -1}, {0.5F, 0, 1}, {}}};
    const FittedView view = from_above(field_of_view);
    const std::vector<BrushStroke> order = painting_order(drawing, view);
    ASSERT_EQ(order.size(), 3U);
    EXPECT_EQ(order[0].kind, Kind::Line);
    EXPECT_EQ(order[1].kind, Kind::Polygon);
    // On the page, the cut coincides with the origin.
    const double from = view.project(drawing.lines[0].from).x;
    const double to = view.project(drawing.lines[0].to).x;
    EXPECT_NEAR(from + order[0].to * (to - from), view.project({0, 0, 0}).x, 0.02);
  }
}

TEST(PaintingOrder, ALineOnAFaceIsNotHidden) {
  Drawing drawing;
  drawing.polygons = {square(0)};
  drawing.lines = {{{-1, -1, 0}, {1, 1, 0}, {}}, {{-1, -1, 0}, {1, -1, 0}, {}}};
  const std::vector<BrushStroke> order = painting_order(drawing, from_above());
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[0].kind, Kind::Polygon);
}

TEST(PaintingOrder, PointsBehindABallComeFirst) {
  Drawing drawing;
  drawing.balls = {{{0, 0, 0}, 1, Role::Faint, 1}};
  drawing.points = {{{0, 0, -1}, Role::Text, 4}, {{0, 0, 1}, Role::Text, 4}};
  const std::vector<BrushStroke> order = painting_order(drawing, from_above());
  EXPECT_LT(place_of(order, Kind::Point, 0), place_of(order, Kind::Ball, 0));
  EXPECT_GT(place_of(order, Kind::Point, 1), place_of(order, Kind::Ball, 0));
}

}  // namespace
}  // namespace cs550::drawing
