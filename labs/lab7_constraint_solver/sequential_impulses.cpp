/// @file sequential_impulses.cpp
/// Lab 7, L7.5 to L7.9: the impulses, one constraint at a time. L7.1 to L7.4 are in
/// constraint_solver.cpp in this folder.

#include "cs550/constraint_solver.hpp"
#include "cs550/not_implemented.hpp"

namespace cs550 {

void warm_start([[maybe_unused]] const ContactConstraint& constraint,
                [[maybe_unused]] SolverBody& a, [[maybe_unused]] SolverBody& b) {
  // L7.5: The three accumulated numbers are one impulse vector. Which body receives it?
  throw NotImplemented("L7.5");
}

void solve_normal([[maybe_unused]] ContactConstraint& constraint, [[maybe_unused]] SolverBody& a,
                  [[maybe_unused]] SolverBody& b, [[maybe_unused]] const ContactStep& step) {
  // L7.6: How far apart are the surfaces now? The bodies have moved since the step began.
  throw NotImplemented("L7.6");
}

void solve_friction([[maybe_unused]] ContactConstraint& constraint, [[maybe_unused]] SolverBody& a,
                    [[maybe_unused]] SolverBody& b) {
  // L7.7: How long may the vector of both impulses be, and where must it point on sliding?
  throw NotImplemented("L7.7");
}

void solve_contacts([[maybe_unused]] std::span<ContactConstraint> constraints,
                    [[maybe_unused]] std::span<SolverBody> bodies,
                    [[maybe_unused]] const ContactStep& step) {
  // L7.8: The reverse pass reverses the order of the constraints and the order within each.
  throw NotImplemented("L7.8");
}

void apply_restitution([[maybe_unused]] std::span<ContactConstraint> constraints,
                       [[maybe_unused]] std::span<SolverBody> bodies,
                       [[maybe_unused]] const ContactStep& step) {
  // L7.9: Which constraints are touching, and which normal velocity should each of them have?
  throw NotImplemented("L7.9");
}

}  // namespace cs550
