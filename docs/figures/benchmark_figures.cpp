#include "benchmark_figures.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cs550::book {
namespace {

using drawing::Plot;
using drawing::SeriesStyle;
using nlohmann::json;

/// A line with a dot at each value, in the next colour.
void add_curve(Plot& plot, const std::string& name, const std::vector<Vec2>& values) {
  const drawing::Role role = drawing::series_role(static_cast<int>(plot.series.size() / 2));
  add_series(plot, name, values).role = role;
  add_series(plot, "", values, SeriesStyle::Dots).role = role;
}

Plot logarithmic_plot(const char* x_label, const std::string& y_label) {
  Plot plot;
  plot.logarithmic = plot.logarithmic_x = true;
  plot.x_label = x_label;
  plot.y_label = y_label;
  return plot;
}

Vec2 point(const json& x, const json& y, double y_unit) {
  return {x.get<Real>(), static_cast<Real>(y.get<double>() / y_unit)};
}

// --- cost against n ------------------------------------------------------------------------------

struct Family {
  const char* name;
  const char* legend;
};

/// The stages of a family, such as support/climb.
std::vector<Vec2> costs_of(const json& report, const std::string& family, double unit) {
  std::vector<Vec2> values;
  for (const json& stage : report.at("stages")) {
    const std::string& name = stage.at("name").get_ref<const std::string&>();
    if (stage.at("n") > 0 && name.starts_with(family + '/')) {
      values.push_back(point(stage.at("n"), stage.at("seconds"), unit));
    }
  }
  return values;
}

template <std::size_t count>
Plot plot_stages(const json& report, const char* title, const Family (&families)[count]) {
  constexpr double microsecond = 1e-6;
  Plot plot = logarithmic_plot("vertices n of each hull", "µs a query");
  plot.title = title;
  for (const auto& [name, legend] : families)
    add_curve(plot, legend, costs_of(report, name, microsecond));
  return plot;
}

Plot plot_steps(const json& report) {
  constexpr double millisecond = 1e-3;
  Plot plot = logarithmic_plot("bodies", "ms a step");
  plot.title = "A step";
  for (const json& family : report.at("scaling")) {
    std::vector<Vec2> values;
    for (const json& cost : family.at("costs"))
      values.push_back(point(cost.at("n"), cost.at("seconds"), millisecond));
    std::string name = family.at("name");
    std::replace(name.begin(), name.end(), '_', ' ');
    add_curve(plot, name, values);
  }
  return plot;
}

constexpr drawing::Size third_of_a_page = {290, 290};

drawing::Page cost_against_n(const json& report) {
  constexpr Family supports[] = {{"support/all", "all vertices"},
                                 {"support/climb", "climb"},
                                 {"support/climb_near", "climb from nearby"}};
  constexpr Family pairs[] = {{"axis/overlap", "axis"},
                              {"manifold/cold", "axis and manifold"},
                              {"manifold/moved", "with last step's answer"},
                              {"axis/crossed_prisms", "edges of crossed prisms"}};
  drawing::Page page;
  page.alt_text = "Three plots with logarithmic axes: support, pairs, steps";
  page.panel_size = third_of_a_page;
  page.panels = {plot_stages(report, "Support", supports),
                 plot_stages(report, "A pair of hulls", pairs), plot_steps(report)};
  return page;
}

// --- frontier ------------------------------------------------------------------------------------

struct Measure {
  const char* key;
  const char* label;
  double unit;
};

/// A curve for each engine. Its values are in the order of effort.
Plot plot_frontier(const json& frontier, const Measure& measure) {
  Plot plot = logarithmic_plot("ms a step", measure.label);
  plot.title = frontier.at("scene").get<std::string>() + ": " + measure.label;
  std::vector<std::pair<std::string, std::vector<Vec2>>> curves;
  for (const json& run : frontier.at("runs")) {
    if (run.at(measure.key).is_null()) continue;
    const std::string& engine = run.at("engine").get_ref<const std::string&>();
    if (curves.empty() || curves.back().first != engine) curves.push_back({engine, {}});
    const double milliseconds = 1e3 * run.at("seconds").get<double>();
    const Vec2 value = point(milliseconds, run.at(measure.key), measure.unit);
    curves.back().second.push_back(value);
    if (value.y() > 0) continue;
    plot.notes.push_back("Below the axis: " + engine + " with " +
                         std::to_string(run.at("effort").get<int>()) + '.');
  }
  for (const auto& [engine, values] : curves) add_curve(plot, engine, values);
  return plot;
}

/// A panel for each scene that has this error.
drawing::Page frontier_of(const json& report, const Measure& measure) {
  drawing::Page page;
  page.alt_text =
      std::string(measure.label) + " over milliseconds per step, a curve for each engine";
  page.panel_size = third_of_a_page;
  for (const json& frontier : report.at("frontiers")) {
    Plot plot = plot_frontier(frontier, measure);
    if (!plot.series.empty()) page.panels.emplace_back(std::move(plot));
  }
  return page;
}

}  // namespace

std::vector<Figure> benchmark_figures(const std::string& text) {
  const json report = json::parse(text);
  std::vector<Figure> figures;
  if (!report.at("stages").empty()) {
    figures.push_back({"cost_against_n", [=] { return cost_against_n(report); }});
  }
  if (report.at("frontiers").empty()) return figures;
  constexpr Measure drift = {"drift", "drift (mm)", 1e-3};
  constexpr Measure depth = {"deepest", "penetration (mm)", 1e-3};
  constexpr Measure energy = {"kinetic_energy", "kinetic energy (J)", 1};
  figures.push_back({"frontier_depth", [=] { return frontier_of(report, depth); }});
  figures.push_back({"frontier_drift", [=] { return frontier_of(report, drift); }});
  figures.push_back({"frontier_energy", [=] { return frontier_of(report, energy); }});
  return figures;
}

}  // namespace cs550::book
