#pragma once
/// @file plot.hpp
/// Curves over an axis: energy over time, error over iterations.

#include <string>
#include <vector>

#include "cs550/math.hpp"
#include "drawing/palette.hpp"

namespace cs550::drawing {

/// How the values of a series are shown.
enum class SeriesStyle : std::uint8_t {
  Curve,  ///< joined by a line
  Steps,  ///< held until the next value
  Dots,   ///< one dot each
  Bars,   ///< one bar each, from zero
};

/// Values that belong together.
struct Series {
  std::string name;                        ///< for the legend
  std::vector<Vec2> values;                ///< (x, y) in the order in which they are joined
  SeriesStyle style = SeriesStyle::Curve;  ///< how they are shown
  Role role = Role::Got;                   ///< what it stands for, or just a colour
  bool dashed = false;                     ///< so that colour is not the only difference
};

/// A level or a moment that is worth a line across the plot.
struct PlotMark {
  Real at = 0;              ///< x or y
  bool vertical = false;    ///< at an x, not a y
  std::string text;         ///< beside it
  Role role = Role::Faint;  ///< what it stands for
};

/// Series on common axes.
struct Plot {
  std::string title;               ///< a few words
  std::string alt_text;            ///< what is to be seen, for those who cannot see it
  std::string x_label;             ///< with its unit: "time (s)"
  std::string y_label;             ///< with its unit
  bool logarithmic = false;        ///< y in powers of ten; values ≤ 0 are left out
  std::vector<Series> series;      ///< at least one
  std::vector<PlotMark> marks;     ///< lines across
  std::vector<std::string> notes;  ///< sentences below the plot
};

/// Adds a series with a colour of its own.
Series& add_series(Plot& plot, const std::string& name, std::vector<Vec2> values,
                   SeriesStyle style = SeriesStyle::Curve);

/// The distance of an axis's ticks: 1, 2 or 5 times a power of ten.
/// @param most steps into which the span is divided
double tick_step(double span, int most);

}  // namespace cs550::drawing
