#include "drawing/plot.hpp"

#include <utility>

namespace cs550::drawing {

Series& add_series(Plot& plot, const std::string& name, std::vector<Vec2> values,
                   SeriesStyle style) {
  const Role role = series_role(static_cast<int>(plot.series.size()));
  plot.series.push_back({name, std::move(values), style, role, false});
  return plot.series.back();
}

}  // namespace cs550::drawing
