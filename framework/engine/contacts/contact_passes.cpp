#include "engine/contacts/contact_passes.hpp"

namespace cs550 {

namespace {

/// An impulse is proportional to the mass, so over-relaxation multiplies the masses.
void over_relax(std::span<ContactConstraint> constraints, Real factor, ConstraintMirror& mirror) {
  mirror.masses.clear();
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    mirror.masses.push_back(constraints[i].normal_mass);
    if (mirror.loads[i] > 0) constraints[i].normal_mass *= factor;
  }
}

void restore_masses(std::span<ContactConstraint> constraints, const ConstraintMirror& mirror) {
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    constraints[i].normal_mass = mirror.masses[i];
  }
}

}  // namespace

[[gnu::weak]] void run_passes(ConstraintMirror& mirror, std::span<ContactConstraint> constraints,
                              std::span<SolverBody> bodies, const ContactStep& step,
                              const Passes& passes) {
  if (mirror.stale) mirror.loads.assign(constraints.size(), 0);
  mirror.stale = false;
  if (passes.warm_start) {
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      const ContactConstraint& constraint = constraints[i];
      warm_start(constraint, bodies[constraint.body_a], bodies[constraint.body_b]);
      mirror.loads[i] = constraint.normal_impulse;
    }
  }
  if (passes.over_relaxation != 1) over_relax(constraints, passes.over_relaxation, mirror);
  ContactStep pass_step = step;
  for (int pass = 0; pass < passes.count; ++pass) {
    pass_step.backwards = passes.goes_backwards(pass);
    solve_contacts(constraints, bodies, pass_step);
  }
  if (passes.over_relaxation != 1) restore_masses(constraints, mirror);
  if (!passes.mark_impacts) return;
  for (ContactConstraint& constraint : constraints) constraint.mark_impact();
}

[[gnu::weak]] bool passes_spare_immovable_bodies() { return false; }

}  // namespace cs550
