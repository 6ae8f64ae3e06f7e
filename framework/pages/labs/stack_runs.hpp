#pragma once
/// @file stack_runs.hpp
/// The solvers of labs 6 and 7 on a stack, pass by pass.

#include <span>
#include <vector>

#include "pages/labs/stack.hpp"

namespace cs550::pages {

/// The stack before the first pass and after each one.
using StackRun = std::vector<Stack>;

/// Runs the solver of lab 6.
StackRun solve_naively(Stack stack, int passes);
/// Runs the solver of lab 7. @param warm initial impulses; if null, a cold start
StackRun solve_accumulating(Stack stack, int passes, std::span<const ContactConstraint> warm);

/// Plots the errors of both solvers, cold and warm, without friction, which the naive solver does
/// not model. A lab that is not written yet is left out. Lab 7 is also left out if boxes bounce,
/// because another of its functions handles restitution.
drawing::Plot compare_solvers(const Stack& start, int passes);

/// A run after one of its passes: boxes, impulses, and the convergence of all passes.
/// @param start the stack that the run solves, before any impulse
/// @param pass counted from the end if negative
Content show_pass(const Stack& start, const StackRun& run, int pass);

}  // namespace cs550::pages
