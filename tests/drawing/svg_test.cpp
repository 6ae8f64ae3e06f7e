// SVG files are well-formed for any values in a drawing.

#include "drawing/svg.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "drawing/fitted_view.hpp"
#include "xml.hpp"

namespace cs550::drawing {
namespace {

using test::count;
using test::xml_fault;

constexpr Real nan_value = std::numeric_limits<Real>::quiet_NaN();

Drawing one_of_each() {
  Drawing drawing;
  drawing.title = "One of each";
  drawing.alt_text = "A triangle, a ball, an arrow, a dot and a label.";
  drawing.polygons.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, Role::BodyA, Real(0.5)});
  drawing.balls.push_back({{2, 0, 0}, Real(0.5), Role::Faint, 1});
  drawing.points.push_back({{0, 0, 1}, Role::Highlight, 4});
  drawing.labels.push_back({{1, 0, 0}, "a < b & \"c\"", Role::Text});
  drawing.legend.push_back({"the <triangle>", {Role::BodyA, 2, false, false}, LegendMark::Patch});
  add_arrow(drawing, {0, 0, 0}, {0, 0, 2}, {Role::Highlight, 3, true, true}, "n̂");
  return drawing;
}

TEST(Svg, IsWellFormed) {
  const std::string svg = write_svg(one_of_each());
  EXPECT_EQ(xml_fault(svg), "") << svg;
  EXPECT_EQ(count(svg, "a &lt; b &amp; &quot;c&quot;"), 1);
}

TEST(Svg, SaysInWordsWhatIsToBeSeen) {
  const std::string svg = write_svg(one_of_each());
  EXPECT_EQ(count(svg, "<title id=\"title\">One of each</title>"), 1);
  EXPECT_EQ(
      count(svg,
            "<desc id=\"description\">A triangle, a ball, an arrow, a dot and a label.</desc>"),
      1);
}

TEST(Svg, LeavesOutWhatIsNotFiniteAndSaysSo) {
  Drawing drawing = one_of_each();
  drawing.points.push_back({{nan_value, 0, 0}, Role::Got, 4});
  drawing.lines.push_back({{0, 0, 0}, {HUGE_VALF, 0, 0}, {}});
  const std::string svg = write_svg(drawing);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "inf"), 0);
  EXPECT_EQ(count(svg, "2 elements have coordinates that are not finite"), 1);
}

TEST(Svg, StaysSmallWhereValuesAreHuge) {
  Drawing drawing = one_of_each();
  drawing.lines.push_back({{0, 0, 0}, {1e18F, 1e18F, 0}, {}});
  View view;
  view.frame = {{-1, -1, -1}, {1, 1, 1}};
  for (const Real field_of_view : {Real(0), Real(0.8)}) {
    view.field_of_view = field_of_view;
    const std::string svg = write_svg(drawing, view);
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_EQ(count(svg, "nan"), 0);
    EXPECT_EQ(count(svg, "inf"), 0);
    EXPECT_EQ(count(svg, "00000000"), 0);
  }
}

TEST(Svg, ValuesWhoseSquaresOverflowAreLeftOut) {
  Drawing drawing = one_of_each();
  drawing.points.push_back({{-3e38F, 3e38F, 3e38F}, Role::Got, 4});
  const std::string svg = write_svg(drawing);
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "1 element has coordinates"), 1);
}

TEST(Svg, AnEmptyDrawingIsAnEmptyPicture) {
  EXPECT_EQ(xml_fault(write_svg(Drawing{})), "");
  EXPECT_EQ(xml_fault(write_svg(Page{})), "");
  EXPECT_EQ(xml_fault(write_svg(Plot{})), "");
}

TEST(FittedView, AFramedBallKeepsItsScaleWhileTheViewTurns) {
  const auto pixels_per_metre = [](bool frames_ball, const Vec3& toward_eye) {
    View view;
    view.toward_eye = toward_eye;
    view.frame.include({-1, -1, -1});
    view.frame.include({1, 1, 1});
    view.frames_ball = frames_ball;
    return FittedView(view, {}, {0, 0, 300, 200}).pixels(Vec3::Zero(), 1);
  };
  for (const Vec3& toward_eye : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 2, 3)}) {
    EXPECT_NEAR(pixels_per_metre(true, toward_eye), 100, 1e-3) << toward_eye.transpose();
  }
  EXPECT_LT(pixels_per_metre(false, {1, 2, 3}), 80) << "the corners of the cube need more room";
}

TEST(Svg, PanelsStandSideBySide) {
  Page page;
  page.title = "Expected beside got";
  page.alt_text = "Twice the same.";
  page.panels = {Scene{one_of_each(), {}}, Scene{one_of_each(), {}}};
  page.notes = {"They are equal."};
  const std::string svg = write_svg(page);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_EQ(count(svg, "role=\"img\" aria-label="), 2);
  EXPECT_EQ(count(svg, "They are equal."), 1);
}

}  // namespace
}  // namespace cs550::drawing
