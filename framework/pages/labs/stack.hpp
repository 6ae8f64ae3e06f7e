#pragma once
/// @file stack.hpp
/// The contact problem on the pages of labs 6 and 7: a stack of boxes. Its constraints are
/// constructed directly, so that it needs no lab's code.

#include <span>
#include <vector>

#include "cs550/contact_constraint.hpp"
#include "drawing/impulse_drawing.hpp"
#include "pages/base/content.hpp"
#include "pages/base/controls.hpp"

namespace cs550::pages {

/// The settings of the stack.
struct StackSettings {
  int boxes = 5;              ///< number of boxes
  Real top_mass = 1;          ///< mass of the top box (kg); the others have 1 kg
  Real push = Real(0.2);      ///< horizontal velocity of the top box (m/s)
  Real friction = Real(0.5);  ///< μ
  Real restitution = 0;       ///< e

  bool operator==(const StackSettings&) const = default;
};

/// Visits the settings that both solvers use.
void describe(StackSettings& settings, ControlVisitor& visit);

/// The state after gravity has acted for one step, before contacts are solved.
struct Stack {
  std::vector<SolverBody> bodies;              ///< the ground first
  std::vector<Vec3> centers;                   ///< of mass (m)
  std::vector<ContactConstraint> constraints;  ///< four under each box
};

/// Length of the step of gravity (s).
inline constexpr Real stack_step = Real(1) / 60;

Stack make_stack(const StackSettings& settings);

/// The boxes and the ground as solids.
std::vector<Solid> stack_solids(const Stack& stack);

/// The largest approach speed of a contact (m/s).
Real approach_error(const Stack& stack);

/// The same stack without friction. Its solution is known: all boxes leave the ground at e times
/// the speed of their impact, and keep their tangential velocities.
Stack without_friction(Stack stack);
/// That solution, for a stack before contacts are solved.
std::vector<SolverBody> frictionless_answer(const Stack& start);
/// The distance of a stack's velocities from a solution: √(2T/m) of the difference, with its
/// kinetic energy T and the mass m of all boxes (m/s). It is a fair measure for every solver.
Real velocity_error(const Stack& stack, std::span<const SolverBody> answer);

/// Plots velocity_error() over the passes of solvers.
drawing::Plot plot_velocity_errors(std::span<const drawing::Convergence> runs);

/// The load under each box: the sum of the normal impulses of its four lower constraints (N·s).
std::vector<Real> level_impulses(const Stack& stack);

/// Plots level_impulses() after each pass.
drawing::Plot plot_levels(std::span<const std::vector<Real>> history);

/// n·(v_B − v_A) at a constraint (m/s).
Real approach_velocity(const ContactConstraint& constraint, const Stack& stack);

/// v_B − v_A at a constraint, along u and v (m/s).
Vec2 slip_velocity(const ContactConstraint& constraint, const Stack& stack);

}  // namespace cs550::pages
