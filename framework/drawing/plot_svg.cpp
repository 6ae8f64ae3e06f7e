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

/// A coordinate on its axis: on a logarithmic one, its decimal logarithm. NaN if it cannot be drawn.
double on_axis(Real value, bool logarithmic) {
  const double number = static_cast<double>(value);
  if (logarithmic) return number > 0 ? std::log10(number) : NAN;
  return number;
}

/// The values that can be drawn, in runs: one that cannot be drawn interrupts a curve.
std::vector<std::vector<Value>> drawable_runs(const Series& series, const Plot& plot) {
  std::vector<std::vector<Value>> runs(1);
  for (const Vec2& value : series.values) {
    const double x = on_axis(value.x(), plot.logarithmic_x);
    const double y = on_axis(value.y(), plot.logarithmic);
    if (std::isfinite(x) && std::isfinite(y)) {
      runs.back().push_back({x, y});
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  return runs;
}

/// Maps values to the page.
class Axes {
 public:
  Axes(const Plot& plot, const Rectangle& area) : area_(area) {
    for (const Series& series : plot.series) {
      for (const std::vector<Value>& run : drawable_runs(series, plot)) {
        for (const Value& value : run) {
          x_.include(value.x);
          y_.include(value.y);
        }
      }
    }
    for (const PlotMark& mark : plot.marks) {
      const double at = on_axis(mark.at, mark.vertical ? plot.logarithmic_x : plot.logarithmic);
      if (std::isfinite(at)) (mark.vertical ? x_ : y_).include(at);
    }
    widen(x_, plot.logarithmic_x ? 0.06 : 0);
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

struct Tick {
  double at;
  std::string text;
};

/// Powers of ten. If there are only one or two of them, their double and fivefold too.
std::vector<Tick> logarithmic_ticks(const Range& range) {
  const bool is_short = range.length() < 2;
  const int step =
      std::max(1, static_cast<int>(std::lround(tick_step(range.length(), most_ticks))));
  std::vector<Tick> result;
  for (int i = static_cast<int>(std::floor(range.low / step)); i * step <= range.high; ++i) {
    const int exponent = i * step;
    for (const int multiple : {1, 2, 5}) {
      const double at = exponent + std::log10(multiple);
      if (at < range.low || at > range.high || (multiple > 1 && !is_short)) continue;
      result.push_back({at, is_short ? number_text(multiple * std::pow(10.0, exponent), 6)
                                     : power_of_ten_text(exponent)});
    }
  }
  return result;
}

std::vector<Tick> ticks(const Range& range, bool logarithmic) {
  if (logarithmic) return logarithmic_ticks(range);
  const double step = tick_step(range.length(), most_ticks);
  std::vector<Tick> result;
  for (double i = std::ceil(range.low / step); i * step <= range.high; ++i) {
    // Rounding may leave 1e-17 in place of zero.
    const double at = std::abs(i) < 0.5 ? 0.0 : i * step;
    result.push_back({at, number_text(at, 6)});
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
  for (const auto& [x, text] : ticks(axes.x_range(), plot.logarithmic_x)) {
    const double left = axes.place(x, 0).x;
    svg.line({left, area.top}, {left, bottom}, grid, 0.8);
    svg.text({left, bottom + tick_length + 11}, text, style);
  }
  style.anchor = Anchor::End;
  for (const auto& [y, text] : ticks(axes.y_range(), plot.logarithmic)) {
    const double top = axes.place(0, y).y;
    svg.line({area.left, top}, {area.left + area.width, top}, grid, 0.8);
    svg.text({area.left - tick_length - 2, top + 4}, text, style);
  }
  svg.line({area.left, bottom}, {area.left + area.width, bottom}, ink, 1.2);
  svg.line({area.left, area.top}, {area.left, bottom}, ink, 1.2);
}

void draw_series(SvgWriter& svg, const Series& series, const Plot& plot, const Axes& axes) {
  const Colour ink = colour(series.role);
  for (const std::vector<Value>& run : drawable_runs(series, plot)) {
    std::vector<PagePoint> points;
    for (const Value& value : run) points.push_back(axes.place(value.x, value.y));
    switch (series.style) {
      case SeriesStyle::Curve:
        if (points.size() == 1) svg.circle(points[0], 3, ink, paper, 1);
        if (points.size() > 1) svg.polyline(points, ink, 2, series.dashed);
        break;
      case SeriesStyle::Dots:
        for (const PagePoint& at : points) svg.circle(at, 3, ink, paper, 0.8);
        break;
    }
  }
}

void draw_mark(SvgWriter& svg, const PlotMark& mark, const Plot& plot, const Axes& axes,
               const Rectangle& area) {
  const double at = on_axis(mark.at, mark.vertical ? plot.logarithmic_x : plot.logarithmic);
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
  return style == SeriesStyle::Dots ? LegendMark::Dot : LegendMark::Line;
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
