#pragma once
/// @file plot_axes.hpp
/// Maps the values of a plot to pixels.

#include <cmath>
#include <string>
#include <vector>

#include "drawing/plot.hpp"
#include "pages/base/camera.hpp"

namespace cs550::viewer {

using namespace pages;

/// The interval of an axis and its pixels.
struct Axis {
  double lower = 0;
  double upper = 1;
  float start = 0;  ///< pixel of the lower end
  float end = 1;    ///< pixel of the upper end
  bool logarithmic = false;

  double shown(double value) const { return logarithmic ? std::log10(value) : value; }
  bool can_show(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  float pixel(double value) const {
    return start + static_cast<float>((shown(value) - lower) / (upper - lower)) * (end - start);
  }
};

/// Both axes of a plot.
struct PlotAxes {
  Axis x;
  Axis y;
};

/// The axes of a plot inside an area, with room for the text above horizontal marks.
/// @param text_height pixels
PlotAxes axes_of(const drawing::Plot& plot, const Area& area, float text_height);

/// Ticks of a linear axis.
std::vector<double> x_ticks(const Axis& x);
/// Ticks of a linear or logarithmic axis. The latter has powers of ten, with their multiples by 2
/// and 5 if there are few.
std::vector<double> y_ticks(const Axis& y);

/// A number in few characters: "0.25", "12k", "1.5M".
std::string tick_text(double value);

}  // namespace cs550::viewer
