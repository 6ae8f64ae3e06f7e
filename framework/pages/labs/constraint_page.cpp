// Lab 7: the same stack, solved by accumulated impulses with and without warm starting.
#include "drawing/impulse_drawing.hpp"
#include "pages/base/units.hpp"
#include "pages/labs/lab_page.hpp"
#include "pages/labs/shapes.hpp"
#include "pages/labs/stack_runs.hpp"

namespace cs550::pages {
namespace {

using drawing::Role;

struct ConstraintSettings {
  StackSettings stack;
  int passes = 200;
  int step = 20;
  bool warm_start = false;
  bool disk = true;
  int constraint = 16;

  bool operator==(const ConstraintSettings&) const = default;
};

void describe(ConstraintSettings& settings, ControlVisitor& visit) {
  visit.section("Passes");
  visit.step({"step", "shown pass", ""}, settings.step, 200);
  visit.whole({"passes", "passes", ""}, settings.passes, 1, 200);
  visit.toggle({"warm_start", "warm start", ""}, settings.warm_start);
  pages::describe(settings.stack, visit);
  visit.number({"friction", "friction", ""}, settings.stack.friction, 0, 2);
  visit.section("Friction disk");
  visit.toggle({"disk", "show", ""}, settings.disk);
  visit.whole({"constraint", "of contact", ""}, settings.constraint, 0, 39);
}

/// Draws the disk beside the stack, flat on the ground. Its radius is proportional to the limit. Friction
/// has the colour that it has in the stack, and one entry in the legend.
void add_disk(const ContactConstraint& constraint, const Stack& before, Content& content) {
  const Real limit = constraint.friction * constraint.normal_impulse;
  if (limit <= 0) return;
  const std::vector<drawing::DiskImpulse> impulses{
      {constraint.tangent_impulse / limit, Role::Incident, "friction"}};
  drawing::Drawing disk =
      drawing::draw_friction_disk(1, impulses, slip_velocity(constraint, before));
  std::erase_if(content.drawing.legend,
                [](const drawing::LegendEntry& entry) { return entry.text == "friction"; });
  const Pose place{{Real(1.55), Real(-0.2), Real(0.02)}, Quat::Identity()};
  drawing::append(content.drawing, drawing::transformed(scaled(disk, Real(0.6)), place));
}

Content show(const ConstraintSettings& settings) {
  const Stack start = make_stack(settings.stack);
  const StackRun cold = solve_accumulating(start, settings.passes, {});
  // Warm starting: the impulses that an earlier step found for the stack at rest.
  const StackRun warm = solve_accumulating(start, settings.passes, cold.back().constraints);
  const StackRun& run = settings.warm_start ? warm : cold;

  Content content = show_pass(start, run, settings.step);
  const std::vector<ContactConstraint>& constraints =
      run[shown_step(settings.step, content.step_count)].constraints;
  const std::size_t constraint =
      std::min(static_cast<std::size_t>(settings.constraint), constraints.size() - 1);
  content.facts.insert(
      content.facts.end(),
      {{"contact", std::to_string(constraint)},
       {"λ normal", quantity(static_cast<double>(constraints[constraint].normal_impulse), "N·s")},
       {"|λ friction|",
        quantity(static_cast<double>(constraints[constraint].tangent_impulse.norm()), "N·s")}});
  if (settings.disk) {
    add_disk(constraints[constraint], start, content);
    content.focus.center.x() += Real(0.5);
  }
  return content;
}

}  // namespace

std::unique_ptr<Page> make_constraint_page(Isolation isolation) {
  LabPageParts<ConstraintSettings> parts;
  parts.lab = 7;
  parts.story =
      "Accumulated impulses may decrease again, so the passes converge to the forces that carry "
      "the stack. Last step's impulses are a better start. Friction stays within its disk.";
  parts.first_view = seen_from(Real(-1.1), Real(0.3));
  parts.describe = describe;
  parts.show = show;
  return std::make_unique<LabPage<ConstraintSettings>>(parts, isolation);
}

}  // namespace cs550::pages
