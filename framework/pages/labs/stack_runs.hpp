#pragma once
/// @file stack_runs.hpp
/// What the solvers of labs 6 and 7 make of a stack, pass by pass.

#include <span>
#include <vector>

#include "pages/labs/stack.hpp"

namespace cs550::pages {

/// The stack after each pass, the first before any.
using StackRun = std::vector<Stack>;

/// By lab 6.
StackRun solve_naively(Stack stack, int passes);
/// By lab 7, accumulating impulses. @param warm impulses to begin with; none starts cold
StackRun solve_accumulating(Stack stack, int passes, std::span<const ContactConstraint> warm);

/// The errors of both, cold and warm, on the same problem: without friction, which the naive solver
/// does not know. A lab that is not written yet is left out, and lab 7 also where boxes bounce: that
/// is another function of it.
drawing::Plot compare_solvers(const Stack& start, int passes);

/// A run after one of its passes: boxes and impulses, and how all passes went.
/// @param start the stack that the run solves, before any impulse
/// @param pass counted from the end if negative
Content show_pass(const Stack& start, const StackRun& run, int pass);

}  // namespace cs550::pages
