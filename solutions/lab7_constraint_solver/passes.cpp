#include "cs550/constraint_solver.hpp"

namespace cs550 {

void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step) {
  const auto body = [&](Index i) -> SolverBody& { return bodies[static_cast<std::size_t>(i)]; };
  if (step.backwards) {
    for (auto constraint = constraints.rbegin(); constraint != constraints.rend(); ++constraint) {
      solve_friction(*constraint, body(constraint->body_a), body(constraint->body_b));
      solve_normal(*constraint, body(constraint->body_a), body(constraint->body_b), step);
    }
  } else {
    for (ContactConstraint& constraint : constraints) {
      solve_normal(constraint, body(constraint.body_a), body(constraint.body_b), step);
      solve_friction(constraint, body(constraint.body_a), body(constraint.body_b));
    }
  }
}

}  // namespace cs550
