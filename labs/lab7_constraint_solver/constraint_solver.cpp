/// @file constraint_solver.cpp
/// Lab 7, L7.1 to L7.4: Jacobian, effective mass and bias of a constraint; L7.5 to L7.9 are in
/// sequential_impulses.cpp. The handout is README.md in this folder. The contract of each function
/// is in framework/include/cs550/constraint_solver.hpp, the constraint in contact_constraint.hpp in
/// the same folder.

#include "cs550/constraint_solver.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: a bead on a vertical wire must not sink below a peg. One body, one direction,
/// one constraint v + b ≥ 0. The functions of this lab do the same with more bodies.
struct Bead {
  Real mass;      // kg
  Real velocity;  // m/s, positive upwards
};

/// Solves the constraint v ≥ −b once and returns the new accumulated impulse of the peg (N·s).
[[maybe_unused]] Real push_bead(Bead& bead, Real accumulated, Real b) {
  // 1. Which impulse would make v + b zero if this were the only constraint?
  const Real wanted = -bead.mass * (bead.velocity + b);

  // 2. The peg can push but not pull. That applies to the *sum* of its impulses: a later impulse
  //    may take back the excess of an earlier one.
  const Real before = accumulated;
  accumulated = before + wanted > 0 ? before + wanted : 0;

  // 3. Apply only the change.
  bead.velocity += (accumulated - before) / bead.mass;
  return accumulated;
}

}  // namespace

ContactJacobian contact_jacobian([[maybe_unused]] const Vec3& direction,
                                 [[maybe_unused]] const Vec3& r_a,
                                 [[maybe_unused]] const Vec3& r_b) {
  // L7.1: Write the velocity along d as four dot products, one for each velocity.
  throw NotImplemented("L7.1");
}

Real constraint_mass([[maybe_unused]] const ContactJacobian& jacobian,
                     [[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b) {
  // L7.2: M is block diagonal, so JM⁻¹Jᵀ is a sum of four terms.
  throw NotImplemented("L7.2");
}

ContactBias contact_bias([[maybe_unused]] const ContactConstraint& constraint,
                         [[maybe_unused]] Real separation,
                         [[maybe_unused]] const ContactStep& step) {
  // L7.3: What does the constraint ask for in each case, and which sign pushes apart?
  throw NotImplemented("L7.3");
}

void prepare_contacts([[maybe_unused]] std::span<ContactConstraint> constraints,
                      [[maybe_unused]] std::span<const SolverBody> bodies,
                      [[maybe_unused]] const ContactStep& step) {
  // L7.4: A push along u also moves the contact along v. What does that mean for the two masses?
  throw NotImplemented("L7.4");
}

}  // namespace cs550
