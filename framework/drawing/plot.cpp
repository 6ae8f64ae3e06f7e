#include "drawing/plot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cs550::drawing {

Series& add_series(Plot& plot, const std::string& name, std::vector<Vec2> values,
                   SeriesStyle style) {
  const Role role = series_role(static_cast<int>(plot.series.size()));
  plot.series.push_back({name, std::move(values), style, role, false});
  return plot.series.back();
}

std::vector<std::string> notes_of(const Plot& plot) {
  std::ptrdiff_t gaps = 0;
  for (const Series& series : plot.series) {
    gaps += std::count_if(series.values.begin(), series.values.end(),
                          [](const Vec2& value) { return !value.allFinite(); });
  }
  std::vector<std::string> notes = plot.notes;
  if (gaps > 0) {
    notes.push_back(std::to_string(gaps) + (gaps == 1 ? " value is" : " values are") +
                    " not finite: left out.");
  }
  return notes;
}

double tick_step(double span, int most) {
  constexpr double rounding = 0.999;  // ignores rounding in the last digit of the span
  const double rough = rounding * span / most;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

}  // namespace cs550::drawing
