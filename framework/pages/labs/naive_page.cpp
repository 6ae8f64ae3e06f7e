// Lab 6: a stack of boxes, solved by impulses that are never reduced.
#include "pages/labs/lab_page.hpp"
#include "pages/labs/stack_runs.hpp"

namespace cs550::pages {
namespace {

struct NaiveSettings {
  StackSettings stack;
  int passes = 200;
  int step = 20;

  bool operator==(const NaiveSettings&) const = default;
};

void describe(NaiveSettings& settings, ControlVisitor& visit) {
  visit.section("Passes");
  visit.step({"step", "shown pass", ""}, settings.step, 200);
  visit.whole({"passes", "passes", ""}, settings.passes, 1, 200);
  pages::describe(settings.stack, visit);
  visit.number({"restitution", "restitution", ""}, settings.stack.restitution, 0, 1);
}

Content show(const NaiveSettings& settings) {
  const Stack start = make_stack(settings.stack);
  Content content = show_pass(start, solve_naively(start, settings.passes), settings.step);
  content.facts.push_back({"contacts", std::to_string(start.constraints.size())});
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

}  // namespace cs550::pages
