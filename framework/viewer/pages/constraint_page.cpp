// Lab 7: the same stack by accumulated impulses, with and without a warm start.
#include "cs550/constraint_solver.hpp"
#include "cs550/naive_solver.hpp"
#include "cs550/not_implemented.hpp"
#include "drawing/impulse_drawing.hpp"
#include "viewer/pages/lab_page.hpp"
#include "viewer/pages/shapes.hpp"
#include "viewer/pages/stack.hpp"
#include "viewer/units.hpp"

namespace cs550::viewer {
namespace {

using drawing::Role;

struct ConstraintSettings {
  StackSettings stack;
  int passes = 30;
  int step = 8;
  bool warm_start = false;
  bool disk = true;
  int row = 16;

  bool operator==(const ConstraintSettings&) const = default;
};

void describe(ConstraintSettings& settings, KnobVisitor& visit) {
  visit.section("Passes");
  visit.whole({"step", "shown pass", ""}, settings.step, -1, 200);
  visit.whole({"passes", "passes", ""}, settings.passes, 1, 200);
  visit.toggle({"warm_start", "warm start", ""}, settings.warm_start);
  viewer::describe(settings.stack, visit);
  visit.section("Friction disk");
  visit.toggle({"disk", "show", ""}, settings.disk);
  visit.whole({"row", "of contact", ""}, settings.row, 0, 39);
}

/// The stack after each pass, the first before any.
using Run = std::vector<Stack>;

/// @param warm impulses to begin with; none starts cold
Run solve(Stack stack, int passes, std::span<const ContactRow> warm) {
  ContactStep step;
  step.h = stack_step;
  step.use_bias = false;  // boxes that touch exactly: a rigid contact
  prepare_contacts(stack.rows, stack.bodies, step);
  for (std::size_t i = 0; i < warm.size(); ++i) {
    ContactRow& row = stack.rows[i];
    row.normal_impulse = warm[i].normal_impulse;
    row.tangent_impulse = warm[i].tangent_impulse;
    warm_start(row, stack.bodies[static_cast<std::size_t>(row.body_a)],
               stack.bodies[static_cast<std::size_t>(row.body_b)]);
  }
  Run run{stack};
  for (int pass = 0; pass < passes; ++pass) {
    step.backwards = pass % 2 == 1;
    solve_contacts(stack.rows, stack.bodies, step);
    run.push_back(stack);
  }
  return run;
}

drawing::Convergence convergence(const char* name, const Run& run, bool dashed) {
  drawing::Convergence result{name, {}, dashed};
  for (const Stack& stack : run) result.errors.push_back(approach_error(stack));
  return result;
}

/// The same stack by lab 6, to compare with; nothing as long as that is not written.
void add_naive(Stack stack, int passes, std::vector<drawing::Convergence>& errors) {
  drawing::Convergence naive{"naive", {approach_error(stack)}, true};
  try {
    for (int pass = 0; pass < passes; ++pass) {
      resolve_contacts_naive(stack.rows, stack.bodies);
      naive.errors.push_back(approach_error(stack));
    }
    errors.push_back(naive);
  } catch (const NotImplemented&) {
    return;
  }
}

std::vector<std::vector<Real>> impulses_of(const Run& run) {
  std::vector<std::vector<Real>> history;
  for (const Stack& stack : run) history.push_back(level_impulses(stack));
  return history;
}

/// Beside the stack, flat on the ground; its radius stands for the limit.
void add_disk(const ContactRow& row, const Stack& before, Content& content) {
  const Real limit = row.friction * row.normal_impulse;
  if (limit <= 0) return;
  const std::vector<drawing::DiskImpulse> impulses{
      {row.tangent_impulse / limit, Role::Highlight, "friction impulse"}};
  const drawing::Drawing disk =
      drawing::draw_friction_disk(1, impulses, slip_velocity(row, before));
  const Pose place{{Real(1.55), Real(-0.7), Real(0.02)}, Quat::Identity()};
  drawing::append(content.drawing, drawing::transformed(scaled(disk, Real(0.6)), place));
}

Content show(const ConstraintSettings& settings) {
  const Stack start = make_stack(settings.stack);
  const Run cold = solve(start, settings.passes, {});
  // The warm start of a stack that stood still: what an earlier step has found.
  const Run warm = solve(start, settings.passes, cold.back().rows);
  const Run& run = settings.warm_start ? warm : cold;

  Content content;
  content.step_count = static_cast<int>(run.size());
  const int step = shown_step(settings.step, content.step_count);
  const Stack& shown = run[static_cast<std::size_t>(step)];
  content.solids = stack_solids(shown);
  const Real scale = drawing::impulse_scale(run.back().rows, Real(0.75));
  content.drawing = drawing::draw_impulses(shown.rows, shown.centers, scale);
  const std::size_t row = std::min(static_cast<std::size_t>(settings.row), shown.rows.size() - 1);
  if (settings.disk) add_disk(shown.rows[row], start, content);

  std::vector<drawing::Convergence> errors{convergence("cold start", cold, false),
                                           convergence("warm start", warm, true)};
  add_naive(start, settings.passes, errors);
  content.plots = {drawing::plot_convergence(errors, "m/s"), plot_levels(impulses_of(run))};
  content.facts = {
      {"pass", std::to_string(step)},
      {"fastest approach", quantity(static_cast<double>(approach_error(shown)), "m/s")},
      {"contact", std::to_string(row)},
      {"λ normal", quantity(static_cast<double>(shown.rows[row].normal_impulse), "N·s")},
      {"|λ friction|",
       quantity(static_cast<double>(shown.rows[row].tangent_impulse.norm()), "N·s")}};
  content.focus = {start.centers[start.centers.size() / 2], Real(0.75) * start.centers.back().z()};
  content.focus.radius = std::max(content.focus.radius, Real(1.2));
  if (settings.disk) content.focus.center.x() += Real(0.5);
  return content;
}

}  // namespace

std::unique_ptr<Page> make_constraint_page(Isolation isolation) {
  LabPageParts<ConstraintSettings> parts;
  parts.lab = 7;
  parts.story =
      "Impulses are accumulated and may go back down, so passes converge to the forces that carry "
      "the "
      "stack. Last step's impulses are a better start; friction stays in its disk.";
  parts.first_view = seen_from(Real(-1.1), Real(0.3));
  parts.describe = describe;
  parts.show = show;
  return std::make_unique<LabPage<ConstraintSettings>>(parts, isolation);
}

}  // namespace cs550::viewer
