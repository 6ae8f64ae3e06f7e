#include "viewer/ui/plot_axes.hpp"

#include <algorithm>
#include <cmath>

#include "pages/base/controls.hpp"

namespace cs550::viewer {

using namespace pages;

using drawing::Plot;
using drawing::Series;

namespace {

template <class Visit>
void for_each_value(const Plot& plot, const Visit& visit) {
  for (const Series& series : plot.series) {
    for (const Vec2& value : series.values) {
      visit(static_cast<double>(value.x()), static_cast<double>(value.y()));
    }
  }
}

void widen(Axis& axis, double value) {
  if (!axis.can_show(value)) return;
  axis.lower = std::min(axis.lower, axis.shown(value));
  axis.upper = std::max(axis.upper, axis.shown(value));
}

/// Adds room above and below the curves. A curve that is flat except for rounding is centred.
void pad(Axis& axis, double share) {
  if (!(axis.lower <= axis.upper)) axis.lower = 0, axis.upper = 1;
  const double middle = std::abs(axis.lower + axis.upper) / 2;
  const double span = axis.upper - axis.lower;
  const bool is_flat = span <= 2e-3 * middle;
  const double room = !is_flat ? share * span : middle > 0 ? 0.1 * middle : 1;
  if (axis.lower != 0) axis.lower -= room;
  axis.upper += room;
}

/// Adds room for the text above horizontal marks.
void make_room(Axis& y, const Plot& plot, float text_height) {
  const float pixels = y.start - y.end;
  if (pixels < 2 * text_height) return;
  const double share = static_cast<double>(text_height / pixels);
  for (const drawing::PlotMark& mark : plot.marks) {
    const auto at = static_cast<double>(mark.at);
    if (mark.vertical || !y.can_show(at)) continue;
    // The interval from the lower end to the mark must fit into the pixels below the text.
    y.upper = std::max(y.upper, y.lower + (y.shown(at) - y.lower) / (1 - share));
  }
}

std::vector<double> even_ticks(const Axis& axis, int most) {
  std::vector<double> ticks;
  const double step = drawing::tick_step(axis.upper - axis.lower, most);
  const double rounding = 1e-6 * step;
  double tick = std::ceil(axis.lower / step) * step;
  for (; tick <= axis.upper + rounding; tick += step) {
    ticks.push_back(std::abs(tick) < rounding ? 0 : tick);
  }
  return ticks;
}

}  // namespace

PlotAxes axes_of(const Plot& plot, const Area& area, float text_height) {
  const double none = HUGE_VAL;
  Axis x{none, -none, area.left, area.left + area.width, false};
  Axis y{none, -none, area.top + area.height, area.top, plot.logarithmic};
  for_each_value(plot, [&](double horizontal, double vertical) {
    if (!y.can_show(vertical)) return;
    widen(x, horizontal);
    widen(y, vertical);
  });
  for (const drawing::PlotMark& mark : plot.marks) {
    widen(mark.vertical ? x : y, static_cast<double>(mark.at));
  }
  if (!(x.lower < x.upper)) {
    if (!std::isfinite(x.lower)) x.lower = 0;
    x.upper = x.lower + 1;
  }
  // The axis of a quantity that is never negative starts at zero.
  if (!y.logarithmic && y.lower > 0 && y.lower < 0.6 * y.upper) y.lower = 0;
  pad(y, 0.08);
  make_room(y, plot, text_height);
  return {x, y};
}

std::vector<double> x_ticks(const Axis& x) { return even_ticks(x, 5); }

std::vector<double> y_ticks(const Axis& y) {
  if (!y.logarithmic) return even_ticks(y, 4);
  std::vector<double> ticks;
  const double span = y.upper - y.lower;
  const double step = std::max(1.0, std::ceil(span / 5));
  for (double decade = std::floor(y.lower); decade <= y.upper; decade += step) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = decade + std::log10(factor);
      const bool wanted = factor == 1 || span < 2;
      if (wanted && tick >= y.lower && tick <= y.upper) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string tick_text(double value) {
  const double magnitude = std::abs(value);
  if (magnitude >= 1e6) return short_number(value / 1e6, 3) + "M";
  if (magnitude >= 1e4) return short_number(value / 1e3, 4) + "k";
  return short_number(value);
}

}  // namespace cs550::viewer
