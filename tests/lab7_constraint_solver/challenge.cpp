// How fast the passes converge on a cold stack.
#include <cs550/challenge.hpp>

#include "lab7_constraint_solver/systems.hpp"

namespace cs550::test {
namespace {

using namespace autograder;

/// Ten cubes of 1 kg that fall at 1 m/s onto the floor and each other, one contact between each two.
System falling_stack() {
  constexpr int cubes = 10;
  System stack = line_of_cubes(cubes + 1);
  stack.bodies[0] = immovable_body();
  for (int i = 1; i <= cubes; ++i) stack.bodies[i].v.x() = -1;
  stack.prepare();
  return stack;
}

/// The speed of the fastest cube: all would be at rest (m/s).
Real fastest(const System& stack) {
  Real speed = 0;
  for (const SolverBody& body : stack.bodies) speed = std::max(speed, body.v.norm());
  return speed;
}

[[maybe_unused]] const bool error_added = add_challenge(
    {"mm/s left in a stack of ten that fell at 1 m/s, after 8 passes", Better::Fewer, [] {
       System stack = falling_stack();
       stack.pass(8, rigid_step());
       return std::lround(1000 * fastest(stack));
     }});

[[maybe_unused]] const bool passes_added =
    add_challenge({"passes until 1 % of that speed is left", Better::Fewer, [] {
                     constexpr long most = 10000;
                     System stack = falling_stack();
                     long passes = 0;
                     for (; fastest(stack) > Real(0.01) && passes < most; ++passes) {
                       stack.pass(1, rigid_step());
                     }
                     return passes;
                   }});

}  // namespace
}  // namespace cs550::test
