#include "pages/world/world_plots.hpp"

namespace cs550::pages {
namespace {

using drawing::Plot;

Plot over_time(const char* title, const char* y_label) {
  Plot plot;
  plot.title = title;
  plot.x_label = "time (s)";
  plot.y_label = y_label;
  return plot;
}

template <class Measure>
void add(Plot& plot, const char* name, const std::deque<StepSample>& history,
         const Measure& measure) {
  std::vector<Vec2> values;
  values.reserve(history.size());
  for (const StepSample& sample : history) {
    values.emplace_back(static_cast<Real>(sample.time), static_cast<Real>(measure(sample)));
  }
  drawing::add_series(plot, name, std::move(values));
}

}  // namespace

std::vector<Plot> world_plots(const std::deque<StepSample>& history, bool with_times) {
  constexpr double milli = 1e3;
  if (history.empty()) return {};
  std::vector<Plot> plots;

  Plot& energy = plots.emplace_back(over_time("Energy", "J"));
  add(energy, "kinetic", history, [](const StepSample& s) { return s.kinetic; });
  add(energy, "potential", history, [](const StepSample& s) { return s.potential; });
  add(energy, "sum", history, [](const StepSample& s) { return s.kinetic + s.potential; });

  Plot& momentum = plots.emplace_back(over_time("Momentum", "kg·m/s"));
  add(momentum, "|P|", history, [](const StepSample& s) { return s.linear.norm(); });

  Plot& penetration = plots.emplace_back(over_time("Deepest penetration", "mm"));
  add(penetration, "depth", history, [](const StepSample& s) { return milli * s.penetration; });

  Plot& contacts = plots.emplace_back(over_time("Contacts", "number"));
  add(contacts, "pairs", history, [](const StepSample& s) { return s.contacts; });
  add(contacts, "points", history, [](const StepSample& s) { return s.points; });

  if (with_times) {
    Plot& times = plots.emplace_back(over_time("Time per step", "ms"));
    for (int stage = 0; stage < stage_count; ++stage) {
      add(times, to_string(static_cast<Stage>(stage)), history,
          [stage](const StepSample& s) { return milli * s.seconds[stage]; });
    }
  }
  return plots;
}

}  // namespace cs550::pages
