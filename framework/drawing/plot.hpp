#pragma once
/// @file plot.hpp
/// Curves over an axis: energy over time, error over iterations.

#include <string>
#include <vector>

#include "cs550/math.hpp"
#include "drawing/palette.hpp"

namespace cs550::drawing {

/// The style of a series.
enum class SeriesStyle : std::uint8_t {
  Curve,  ///< joined by a line
  Dots,   ///< one dot each
};

/// The values of one curve.
struct Series {
  std::string name;                        ///< for the legend
  std::vector<Vec2> values;                ///< (x, y) in the order in which they are joined
  SeriesStyle style = SeriesStyle::Curve;  ///< its style
  Role role = Role::Got;                   ///< its meaning, or only a colour
  bool dashed = false;                     ///< so that colour is not the only difference
};

/// A line across the plot, at a level or a time.
struct PlotMark {
  Real at = 0;              ///< x or y
  bool vertical = false;    ///< at an x instead of a y
  std::string text;         ///< its label
  Role role = Role::Faint;  ///< its meaning
};

/// Series on common axes.
struct Plot {
  std::string title;               ///< a few words
  std::string alt_text;            ///< a description for readers who cannot see it
  std::string x_label;             ///< with its unit: "time (s)"
  std::string y_label;             ///< with its unit
  bool logarithmic = false;        ///< y in powers of ten; values ≤ 0 are left out
  bool logarithmic_x = false;      ///< the same for x; not in the viewer's window
  std::vector<Series> series;      ///< at least one
  std::vector<PlotMark> marks;     ///< lines across
  std::vector<std::string> notes;  ///< sentences below the plot
};

/// Adds a series with the next colour.
Series& add_series(Plot& plot, const std::string& name, std::vector<Vec2> values,
                   SeriesStyle style = SeriesStyle::Curve);

/// The sentences below a plot: its notes, and how many values are not finite, if any are. Curves are
/// interrupted there.
std::vector<std::string> notes_of(const Plot& plot);

/// The distance between ticks of an axis: 1, 2 or 5 times a power of ten.
/// @param most number of steps in the span
double tick_step(double span, int most);

}  // namespace cs550::drawing
