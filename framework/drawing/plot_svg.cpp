#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/svg_parts.hpp"
#include "drawing/text.hpp"

namespace cs550::drawing {
namespace {

constexpr double tick_length = 4;
constexpr int most_ticks = 6;

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
  double length() const { return high - low; }
};

struct Value {
  double x, y;
};

/// The values that can be drawn. On a logarithmic axis, y is replaced by its decimal logarithm.
std::vector<Value> drawable(const Series& series, bool logarithmic) {
  std::vector<Value> result;
  for (const Vec2& value : series.values) {
    const double x = static_cast<double>(value.x());
    double y = static_cast<double>(value.y());
    if (!std::isfinite(x) || !std::isfinite(y) || (logarithmic && y <= 0)) continue;
    if (logarithmic) y = std::log10(y);
    result.push_back({x, y});
  }
  return result;
}

std::string tick_text(double value, double step, bool logarithmic) {
  if (logarithmic) return power_of_ten_text(static_cast<int>(std::lround(value)));
  // Rounding may leave 1e-17 in place of zero.
  return number_text(std::abs(value) < 1e-9 * step ? 0.0 : value, 6);
}

/// Maps values to the page.
class Axes {
 public:
  Axes(const Plot& plot, const Rectangle& area) : area_(area) {
    for (const Series& series : plot.series) {
      for (const Value& value : drawable(series, plot.logarithmic)) {
        x_.include(value.x);
        y_.include(value.y);
      }
      if (series.style == SeriesStyle::Bars && !x_.is_empty()) {
        y_.include(0);
        x_.include(x_.low - 0.5);
        x_.include(x_.high + 0.5);
      }
    }
    for (const PlotMark& mark : plot.marks) {
      const double at = static_cast<double>(mark.at);
      if (!std::isfinite(at) || (plot.logarithmic && !mark.vertical && at <= 0)) continue;
      if (mark.vertical) {
        x_.include(at);
      } else {
        y_.include(plot.logarithmic ? std::log10(at) : at);
      }
    }
    widen(x_, 0);
    widen(y_, 0.06);
  }

  const Range& x_range() const { return x_; }
  const Range& y_range() const { return y_; }
  PagePoint place(double x, double y) const {
    return {area_.left + area_.width * (x - x_.low) / (x_.high - x_.low),
            area_.top + area_.height * (y_.high - y) / (y_.high - y_.low)};
  }

 private:
  static void widen(Range& range, double share) {
    if (range.is_empty()) range = {0, 1};
    double length = range.length();
    // A constant needs an axis of nonzero length.
    if (length <= 1e-6 * std::max(std::abs(range.low), std::abs(range.high))) {
      length = std::max(0.1 * std::abs(range.low), 1e-6);
      share = 0.5;
    }
    range.low -= share * length;
    range.high += share * length;
  }

  Rectangle area_;
  Range x_, y_;
};

std::vector<double> ticks(const Range& range, bool logarithmic) {
  double step = tick_step(range.length(), most_ticks);
  if (logarithmic) step = std::max(1.0, std::round(step));
  std::vector<double> result;
  for (double i = std::ceil(range.low / step); i * step <= range.high; ++i) {
    result.push_back(i * step);
  }
  return result;
}

void draw_axes(SvgWriter& svg, const Plot& plot, const Axes& axes, const Rectangle& area) {
  const Colour grid = mix(colour(Role::Faint), paper, 0.6);
  const Colour ink = colour(Role::Axis);
  TextStyle style;
  style.size = small_text - 1;
  style.colour = ink;
  style.anchor = Anchor::Middle;
  const double bottom = area.top + area.height;
  for (const double x : ticks(axes.x_range(), false)) {
    const double left = axes.place(x, 0).x;
    svg.line({left, area.top}, {left, bottom}, grid, 0.8);
    svg.text({left, bottom + tick_length + 11},
             tick_text(x, tick_step(axes.x_range().length(), most_ticks), false), style);
  }
  style.anchor = Anchor::End;
  for (const double y : ticks(axes.y_range(), plot.logarithmic)) {
    const double top = axes.place(0, y).y;
    svg.line({area.left, top}, {area.left + area.width, top}, grid, 0.8);
    svg.text({area.left - tick_length - 2, top + 4},
             tick_text(y, tick_step(axes.y_range().length(), most_ticks), plot.logarithmic), style);
  }
  svg.line({area.left, bottom}, {area.left + area.width, bottom}, ink, 1.2);
  svg.line({area.left, area.top}, {area.left, bottom}, ink, 1.2);
}

void draw_series(SvgWriter& svg, const Series& series, const Plot& plot, const Axes& axes) {
  const Colour ink = colour(series.role);
  std::vector<PagePoint> points;
  for (const Value& value : drawable(series, plot.logarithmic)) {
    const PagePoint at = axes.place(value.x, value.y);
    if (series.style == SeriesStyle::Steps && !points.empty()) {
      points.push_back({at.x, points.back().y});
    }
    points.push_back(at);
  }
  switch (series.style) {
    case SeriesStyle::Curve:
    case SeriesStyle::Steps:
      if (points.size() == 1) svg.circle(points[0], 3, ink, paper, 1);
      if (points.size() > 1) svg.polyline(points, ink, 2, series.dashed);
      return;
    case SeriesStyle::Dots:
      for (const PagePoint& at : points) svg.circle(at, 3, ink, paper, 0.8);
      return;
    case SeriesStyle::Bars:
      const double zero = axes.place(0, 0).y;
      const double half = std::max(0.5, 0.36 * (axes.place(1, 0).x - axes.place(0, 0).x));
      for (const PagePoint& at : points) {
        svg.polygon(
            {{at.x - half, at.y}, {at.x + half, at.y}, {at.x + half, zero}, {at.x - half, zero}},
            ink, 1);
      }
      return;
  }
}

void draw_mark(SvgWriter& svg, const PlotMark& mark, const Plot& plot, const Axes& axes,
               const Rectangle& area) {
  double at = static_cast<double>(mark.at);
  if (plot.logarithmic && !mark.vertical) at = at > 0 ? std::log10(at) : NAN;
  if (!std::isfinite(at)) return;
  const PagePoint place = mark.vertical ? axes.place(at, 0) : axes.place(0, at);
  const PagePoint from =
      mark.vertical ? PagePoint{place.x, area.top} : PagePoint{area.left, place.y};
  const PagePoint to = mark.vertical ? PagePoint{place.x, area.top + area.height}
                                     : PagePoint{area.left + area.width, place.y};
  svg.line(from, to, colour(mark.role), 1.4, true);
  TextStyle style;
  style.size = small_text - 1;
  style.colour = mix(colour(mark.role), colour(Role::Text), 0.4);
  style.halo = true;
  style.anchor = mark.vertical ? Anchor::Start : Anchor::End;
  svg.text(mark.vertical ? PagePoint{place.x + 4, area.top + 11} : PagePoint{to.x - 2, place.y - 4},
           mark.text, style);
}

LegendMark legend_mark(SeriesStyle style) {
  switch (style) {
    case SeriesStyle::Curve:
    case SeriesStyle::Steps:
      return LegendMark::Line;
    case SeriesStyle::Dots:
      return LegendMark::Dot;
    case SeriesStyle::Bars:
      return LegendMark::Patch;
  }
  return LegendMark::Line;
}

}  // namespace

void draw_plot(SvgWriter& svg, const Plot& plot, const Rectangle& area) {
  const Rectangle inner = {area.left + 62, area.top + 10, area.width - 78, area.height - 56};
  const Axes axes(plot, inner);
  draw_axes(svg, plot, axes, inner);
  svg.begin_clipped({inner.left - 4, inner.top - 4, inner.width + 8, inner.height + 8});
  for (const Series& series : plot.series) draw_series(svg, series, plot, axes);
  svg.end_group();
  for (const PlotMark& mark : plot.marks) draw_mark(svg, mark, plot, axes, inner);
  TextStyle style;
  style.size = small_text;
  style.anchor = Anchor::Middle;
  svg.text({inner.left + 0.5 * inner.width, inner.top + inner.height + 34}, plot.x_label, style);
  style.upward = true;
  svg.text({area.left + 13, inner.top + 0.5 * inner.height}, plot.y_label, style);
}

std::vector<LegendEntry> legend_of(const Plot& plot) {
  std::vector<LegendEntry> legend;
  for (const Series& series : plot.series) {
    if (series.name.empty()) continue;
    const Stroke stroke = {series.role, 2, series.dashed, false};
    legend.push_back({series.name, stroke, legend_mark(series.style)});
  }
  return legend;
}

}  // namespace cs550::drawing
