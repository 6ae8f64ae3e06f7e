#include "pages/labs/stack_runs.hpp"

#include "cs550/constraint_solver.hpp"
#include "cs550/naive_solver.hpp"
#include "cs550/not_implemented.hpp"
#include "pages/base/units.hpp"
#include "pages/labs/lab_page.hpp"

namespace cs550::pages {

StackRun solve_naively(Stack stack, int passes) {
  StackRun run{stack};
  for (int pass = 0; pass < passes; ++pass) {
    resolve_contacts_naive(stack.constraints, stack.bodies);
    run.push_back(stack);
  }
  return run;
}

StackRun solve_accumulating(Stack stack, int passes, std::span<const ContactConstraint> warm) {
  ContactStep step;
  step.h = stack_step;
  step.use_bias = false;  // rigid contacts: the boxes touch exactly
  prepare_contacts(stack.constraints, stack.bodies, step);
  for (std::size_t i = 0; i < warm.size(); ++i) {
    ContactConstraint& constraint = stack.constraints[i];
    constraint.normal_impulse = warm[i].normal_impulse;
    constraint.tangent_impulse = warm[i].tangent_impulse;
    warm_start(constraint, stack.bodies[constraint.body_a], stack.bodies[constraint.body_b]);
  }
  StackRun run{stack};
  for (int pass = 0; pass < passes; ++pass) {
    step.backwards = pass % 2 == 1;
    solve_contacts(stack.constraints, stack.bodies, step);
    run.push_back(stack);
  }
  return run;
}

drawing::Plot compare_solvers(const Stack& start, int passes) {
  const Stack slippery = without_friction(start);
  const std::vector<SolverBody> answer = frictionless_answer(slippery);
  std::vector<drawing::Convergence> curves;
  const auto add = [&](const char* name, const StackRun& run, bool dashed) {
    drawing::Convergence& curve = curves.emplace_back(drawing::Convergence{name, {}, dashed});
    for (const Stack& stack : run) curve.errors.push_back(velocity_error(stack, answer));
  };
  try {
    add("naive", solve_naively(slippery, passes), true);
  } catch (const NotImplemented&) {
    // The page of lab 7 works without lab 6.
  }
  const bool bounces = start.constraints.front().restitution > 0;
  try {
    if (!bounces) {
      const StackRun cold = solve_accumulating(slippery, passes, {});
      add("accumulated", cold, false);
      add("warm start", solve_accumulating(slippery, passes, cold.back().constraints), false);
    }
  } catch (const NotImplemented&) {
    // Students write lab 6 before lab 7.
  }
  return plot_velocity_errors(curves);
}

Content show_pass(const Stack& start, const StackRun& run, int pass) {
  Content content;
  content.step_count = static_cast<int>(run.size());
  const int step = shown_step(pass, content.step_count);
  const Stack& shown = run[step];
  content.solids = stack_solids(shown);
  const Real scale = drawing::impulse_scale(run.back().constraints, Real(0.75));
  content.drawing = drawing::draw_impulses(shown.constraints, shown.centers, scale);
  std::vector<std::vector<Real>> history;
  for (const Stack& stack : run) history.push_back(level_impulses(stack));
  content.plots = {compare_solvers(start, content.step_count - 1), plot_levels(history)};
  content.facts = {
      {"pass", std::to_string(step)},
      {"fastest approach", quantity(static_cast<double>(approach_error(shown)), "m/s")}};
  content.focus = {start.centers[start.centers.size() / 2], Real(0.75) * start.centers.back().z()};
  content.focus.radius = std::max(content.focus.radius, Real(1.2));
  return content;
}

}  // namespace cs550::pages
