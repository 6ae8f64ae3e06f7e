#include "engine/contacts/contact_passes.hpp"

namespace cs550 {

[[gnu::weak]] void run_passes(ConstraintMirror& /*mirror*/,
                              std::span<ContactConstraint> constraints,
                              std::span<SolverBody> bodies, const ContactStep& step,
                              const Passes& passes) {
  if (passes.warm_start) {
    for (const ContactConstraint& constraint : constraints) {
      warm_start(constraint, bodies[constraint.body_a], bodies[constraint.body_b]);
    }
  }
  ContactStep pass_step = step;
  for (int pass = 0; pass < passes.count; ++pass) {
    pass_step.backwards = passes.goes_backwards(pass);
    solve_contacts(constraints, bodies, pass_step);
  }
  if (!passes.mark_impacts) return;
  for (ContactConstraint& constraint : constraints) constraint.mark_impact();
}

[[gnu::weak]] bool passes_spare_immovable_bodies() { return false; }

}  // namespace cs550
