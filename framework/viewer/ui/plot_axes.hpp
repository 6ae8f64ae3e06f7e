#pragma once
/// @file plot_axes.hpp
/// From the values of a plot to pixels.

#include <cmath>
#include <string>
#include <vector>

#include "drawing/plot.hpp"
#include "pages/base/camera.hpp"

namespace cs550::viewer {

using namespace pages;

/// What one axis shows, and where.
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

/// Places on an axis that is not logarithmic.
std::vector<double> x_ticks(const Axis& x);
/// Places on the axis; on a logarithmic one powers of ten, and twice and five times those where
/// there would be few.
std::vector<double> y_ticks(const Axis& y);

/// A number in few characters.
std::string tick_text(double value);

}  // namespace cs550::viewer
