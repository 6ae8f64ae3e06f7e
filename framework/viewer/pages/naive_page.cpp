// Lab 6: a stack of boxes by impulses that are never taken back.
#include "drawing/impulse_drawing.hpp"
#include "viewer/pages/lab_page.hpp"
#include "viewer/pages/stack_runs.hpp"
#include "viewer/units.hpp"

namespace cs550::viewer {
namespace {

struct NaiveSettings {
  StackSettings stack;
  int passes = 200;
  int step = 20;

  bool operator==(const NaiveSettings&) const = default;
};

void describe(NaiveSettings& settings, KnobVisitor& visit) {
  visit.section("Passes");
  visit.whole({"step", "shown pass", ""}, settings.step, -1, 200);
  visit.whole({"passes", "passes", ""}, settings.passes, 1, 200);
  viewer::describe(settings.stack, visit);
  visit.number({"restitution", "restitution", ""}, settings.stack.restitution, 0, 1);
}

Content show(const NaiveSettings& settings) {
  const Stack start = make_stack(settings.stack);
  const StackRun run = solve_naively(start, settings.passes);
  Content content;
  content.step_count = static_cast<int>(run.size());
  const int step = shown_step(settings.step, content.step_count);
  const Stack& shown = run[static_cast<std::size_t>(step)];
  content.solids = stack_solids(shown);
  const Real scale = drawing::impulse_scale(run.back().rows, Real(0.75));
  content.drawing = drawing::draw_impulses(shown.rows, shown.centers, scale);
  std::vector<std::vector<Real>> history;
  for (const Stack& stack : run) history.push_back(level_impulses(stack));
  content.plots = {compare_solvers(start, settings.passes), plot_levels(history)};
  content.facts = {
      {"pass", std::to_string(step)},
      {"fastest approach", quantity(static_cast<double>(approach_error(shown)), "m/s")},
      {"contacts", std::to_string(shown.rows.size())}};
  content.focus = {start.centers[start.centers.size() / 2], Real(0.75) * start.centers.back().z()};
  content.focus.radius = std::max(content.focus.radius, Real(1.2));
  return content;
}

}  // namespace

std::unique_ptr<Page> make_naive_page(Isolation isolation) {
  LabPageParts<NaiveSettings> parts;
  parts.lab = 6;
  parts.story =
      "Each contact that approaches gets an impulse, one after the other. Every impulse disturbs "
      "its neighbours, and none is ever taken back.";
  parts.first_view = seen_from(Real(-1.1), Real(0.25));
  parts.describe = describe;
  parts.show = show;
  return std::make_unique<LabPage<NaiveSettings>>(parts, isolation);
}

}  // namespace cs550::viewer
