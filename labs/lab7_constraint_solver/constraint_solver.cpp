// Lab 7, L7.1 to L7.4: what a constraint asks for; sequential_impulses.cpp goes on from here. The handout is
// README.md in this folder; what each function promises is in
// framework/include/cs550/constraint_solver.hpp, and the constraints in contact_constraint.hpp beside it.

#include "cs550/constraint_solver.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

// A worked example, complete: a bead on a vertical wire must not sink below a peg. One body, one
// direction, one constraint v + b ≥ 0. Every function of this lab does the same with more bodies.

struct Bead {
  Real mass;      // kg
  Real velocity;  // m/s, positive upwards
};

// Asks for v ≥ −b once more and returns the impulse that the peg has given in all (N·s).
[[maybe_unused]] Real push_bead(Bead& bead, Real accumulated, Real b) {
  // 1. What impulse would make v + b zero, if this were the only constraint?
  const Real wanted = -bead.mass * (bead.velocity + b);

  // 2. The peg can push but not pull. That holds for the *sum* of its impulses: a later one may take
  //    back what an earlier one gave too much.
  const Real before = accumulated;
  accumulated = before + wanted > 0 ? before + wanted : 0;

  // 3. Apply only what is new.
  bead.velocity += (accumulated - before) / bead.mass;
  return accumulated;
}

}  // namespace

ContactJacobian contact_jacobian([[maybe_unused]] const Vec3& direction,
                                 [[maybe_unused]] const Vec3& r_a,
                                 [[maybe_unused]] const Vec3& r_b) {
  // L7.1, step 1: write d·(v_B + ω_B × r_B − v_A − ω_A × r_A) as a sum of four dot products, each
  //               with one of v_A, ω_A, v_B, ω_B. The triple product d·(ω × r) can be turned round.
  // L7.1, step 2: the four vectors beside the velocities are the row of J.
  // See README.md, L7.1.
  throw NotImplemented("L7.1");
}

Real constraint_mass([[maybe_unused]] const ContactJacobian& jacobian,
                     [[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b) {
  // L7.2, step 1: M⁻¹ is block diagonal: 1/m and the world inverse inertia of A, then those of B.
  // L7.2, step 2: J·M⁻¹·Jᵀ is therefore a sum of four terms.
  // L7.2, step 3: invert it. What is the answer for two bodies that cannot move?
  // See README.md, L7.2.
  throw NotImplemented("L7.2");
}

ContactBias contact_bias([[maybe_unused]] const ContactConstraint& constraint,
                         [[maybe_unused]] Real separation,
                         [[maybe_unused]] const ContactStep& step) {
  // L7.3, step 1: apart: how fast may the gap close, so that it is just gone after the substep?
  // L7.3, step 2: in penetration, unless this is the relax pass: how fast is it to be undone, by a
  //               share of the error beyond the slop (Baumgarte) or by a spring, which knows no slop
  //               (soft)? Not faster than the largest push speed.
  // L7.3, step 3: a soft contact also brings its two scales along.
  // L7.3, step 4: in the Baumgarte model the bias may ask for a bounce, too. Do you add the two?
  // See README.md, L7.3.
  throw NotImplemented("L7.3");
}

void prepare_contacts([[maybe_unused]] std::span<ContactConstraint> constraints,
                      [[maybe_unused]] std::span<const SolverBody> bodies,
                      [[maybe_unused]] const ContactStep& step) {
  // L7.4, step 1: the normal mass, from L7.1 and L7.2.
  // L7.4, step 2: the tangents u and v feel each other: put J·M⁻¹·Jᵀ of the two together into a
  //               2 × 2 matrix, with the coupling beside the diagonal, and invert that.
  // L7.4, step 3: choose the softness: which one, if a body cannot move?
  // See README.md, L7.4.
  throw NotImplemented("L7.4");
}

}  // namespace cs550
