#pragma once
/// @file stack.hpp
/// The contact problem that the pages of labs 6 and 7 solve: boxes on top of each other. It is made
/// by hand, so that it needs no lab's code.

#include <span>
#include <vector>

#include "cs550/contact_constraint.hpp"
#include "drawing/impulse_drawing.hpp"
#include "pages/base/content.hpp"
#include "pages/base/controls.hpp"

namespace cs550::pages {

/// What the stack is like.
struct StackSettings {
  int boxes = 5;              ///< on top of each other
  Real top_mass = 1;          ///< of the uppermost box (kg); the others have 1 kg
  Real push = Real(0.2);      ///< sideways velocity of the uppermost box (m/s)
  Real friction = Real(0.5);  ///< μ
  Real restitution = 0;       ///< e

  bool operator==(const StackSettings&) const = default;
};

/// Visits those that both solvers know.
void describe(StackSettings& settings, ControlVisitor& visit);

/// A moment after gravity acted for one step and before any contact did.
struct Stack {
  std::vector<SolverBody> bodies;              ///< the ground first
  std::vector<Vec3> centers;                   ///< of mass (m)
  std::vector<ContactConstraint> constraints;  ///< four under each box
};

/// Length of the step that gravity acted for (s).
inline constexpr Real stack_step = Real(1) / 60;

Stack make_stack(const StackSettings& settings);

/// The boxes and the ground, for the painter.
std::vector<Solid> stack_solids(const Stack& stack);

/// The largest speed at which a contact still approaches (m/s).
Real approach_error(const Stack& stack);

/// The same stack without friction, whose answer is known: all boxes together leave the ground at e
/// times the speed at which they met it, and keep the rest of their velocities.
Stack without_friction(Stack stack);
/// That answer, for a stack before any contact acted.
std::vector<SolverBody> frictionless_answer(const Stack& start);
/// How far the velocities of a stack are from an answer: √(2T/m) of the difference, with T its
/// kinetic energy and m the mass of all boxes, so that every solver is measured alike (m/s).
Real velocity_error(const Stack& stack, std::span<const SolverBody> answer);

/// velocity_error() over the passes of some solvers.
drawing::Plot plot_velocity_errors(std::span<const drawing::Convergence> runs);

/// What carries each box: the normal impulses of the four constraints under it together (N·s).
std::vector<Real> level_impulses(const Stack& stack);

/// level_impulses() after each pass.
drawing::Plot plot_levels(std::span<const std::vector<Real>> history);

/// n·(velocity of B − velocity of A) at a constraint (m/s).
Real approach_velocity(const ContactConstraint& constraint, const Stack& stack);

/// Velocity of B relative to A at a constraint, along u and v (m/s).
Vec2 slip_velocity(const ContactConstraint& constraint, const Stack& stack);

}  // namespace cs550::pages
