// Plots: every value is at its position, and values outside of the axes are left out.

#include "drawing/plot.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "drawing/impulse_drawing.hpp"
#include "drawing/svg.hpp"
#include "drawing/text.hpp"
#include "xml.hpp"

namespace cs550::drawing {
namespace {

using test::count;

TEST(Plot, EachSeriesIsDrawnInItsStyle) {
  Plot plot;
  const std::vector<Vec2> values = {{0, 1}, {1, 3}, {2, 2}};
  add_series(plot, "series", values, SeriesStyle::Curve);
  add_series(plot, "series", values, SeriesStyle::Dots);
  const std::string svg = write_svg(plot);
  EXPECT_EQ(test::xml_fault(svg), "");
  EXPECT_EQ(count(svg, "<polyline"), 1);
  EXPECT_EQ(count(svg, "<polygon"), 0);
  EXPECT_EQ(count(svg, "<circle"), 3 + 1);  // one in the legend
}

TEST(Plot, ALogarithmicAxisLeavesOutWhatHasNoLogarithm) {
  Plot plot;
  plot.logarithmic = true;
  add_series(plot, "error", {{0, 1}, {1, 0}, {2, -1}, {3, NAN}, {4, Real(1e-6)}},
             SeriesStyle::Dots);
  const std::string svg = write_svg(plot);
  EXPECT_EQ(count(svg, "<circle"), 2 + 1);
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_EQ(count(svg, "inf"), 0);
}

TEST(Plot, ACurveIsInterruptedWhereAValueIsNotFinite) {
  Plot plot;
  add_series(plot, "energy", {{-1, 1}, {0, 1}, {1, NAN}, {2, 3}, {3, 3}});
  const std::string svg = write_svg(plot);
  EXPECT_EQ(count(svg, "<polyline"), 2);
  EXPECT_EQ(count(svg, "1 value is not finite: left out."), 1);
  plot.series[0].values = {{0, 1}, {1, NAN}, {2, 3}};
  EXPECT_EQ(count(write_svg(plot), "<polyline"), 0) << "a dot on each side";
}

TEST(Plot, APowerLawIsAStraightLineOnLogarithmicAxes) {
  Plot plot;
  plot.logarithmic = plot.logarithmic_x = true;
  add_series(plot, "cost", {{1, 1}, {10, 100}, {0, 5}, {-1, 5}, {1000, Real(1e6)}},
             SeriesStyle::Dots);
  const std::string svg = write_svg(plot);
  const auto centre = [&](int i) {
    std::size_t at = 0;
    for (int k = 0; k <= i; ++k) at = svg.find("<circle cx=\"", at + 1);
    double x = 0, y = 0;
    EXPECT_EQ(std::sscanf(svg.c_str() + at, "<circle cx=\"%lf\" cy=\"%lf\"", &x, &y), 2);
    return Eigen::Vector2d(x, y);
  };
  EXPECT_EQ(count(svg, "<circle"), 3 + 1) << "0 and −1 have no logarithm";
  const Eigen::Vector2d decade = centre(1) - centre(0);
  EXPECT_LT((centre(2) - centre(1) - 2 * decade).norm(), 0.1);
  EXPECT_GT(decade.x(), 10);
}

TEST(Plot, AShortLogarithmicAxisHasTicksBetweenPowersOfTen) {
  Plot plot;
  plot.logarithmic_x = true;
  add_series(plot, "cost", {{Real(0.4), 0}, {6, 1}});
  const std::string svg = write_svg(plot);
  for (const char* tick : {">0.5<", ">1<", ">2<", ">5<"}) EXPECT_GE(count(svg, tick), 1) << tick;
}

TEST(Plot, AShortLogarithmicAxisWritesThousandsWithoutAnExponent) {
  Plot plot;
  plot.logarithmic = true;
  add_series(plot, "drift", {{0, 120}, {1, 6000}});
  const std::string svg = write_svg(plot);
  for (const char* tick : {">200<", ">500<", ">1000<", ">2000<", ">5000<"}) {
    EXPECT_EQ(count(svg, tick), 1) << tick;
  }
}

TEST(Plot, AConstantHasAnAxis) {
  Plot plot;
  add_series(plot, "energy", {{0, 5}, {1, 5}});
  const std::string svg = write_svg(plot);
  EXPECT_EQ(count(svg, "nan"), 0);
  EXPECT_GE(count(svg, ">5<"), 1);
}

TEST(Plot, MarksStretchTheAxes) {
  Plot plot;
  add_series(plot, "energy", {{0, 1}, {1, 2}});
  plot.marks.push_back({20, false, "bound", Role::Warning});
  EXPECT_GE(count(write_svg(plot), ">20<"), 1);
}

TEST(Plot, NeighbouringSeriesHaveDifferentColours) {
  for (int i = 0; i < 5; ++i)
    EXPECT_NE(hex(colour(series_role(i))), hex(colour(series_role(i + 1))));
}

TEST(Plot, ConvergenceHasOneValuePerPass) {
  const Convergence runs[] = {{"naive", {1, Real(0.5), Real(0.25)}, false}};
  const Plot plot = plot_convergence(runs, "error (m/s)");
  ASSERT_EQ(plot.series.size(), 1U);
  EXPECT_EQ(plot.series[0].values.size(), 3U);
  EXPECT_TRUE(plot.logarithmic);
}

TEST(Text, NumbersAreWrittenAsPeopleWriteThem) {
  EXPECT_EQ(number_text(-0.4259, 3), "−0.426");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(length_text(-0.0123), "−12.3 mm");
  EXPECT_EQ(length_text(1.25), "1.25 m");
  EXPECT_EQ(power_of_ten_text(-2), "0.01");
  EXPECT_EQ(power_of_ten_text(-12), "10⁻¹²");
}

TEST(Palette, RolesThatStandSideBySideDiffer) {
  EXPECT_FALSE(colour(Role::Expected) == colour(Role::Got));
  EXPECT_FALSE(colour(Role::BodyA) == colour(Role::BodyB));
  EXPECT_FALSE(colour(Role::Reference) == colour(Role::Incident));
  EXPECT_EQ(hex(colour(Role::BodyA)), "#0072b2");
}

}  // namespace
}  // namespace cs550::drawing
