// Lab 7, L7.5 to L7.9: the impulses, one constraint after the other. What comes before is in
// constraint_solver.cpp beside this file.

#include "cs550/constraint_solver.hpp"
#include "cs550/not_implemented.hpp"

namespace cs550 {

void warm_start([[maybe_unused]] const ContactConstraint& constraint,
                [[maybe_unused]] SolverBody& a, [[maybe_unused]] SolverBody& b) {
  // L7.5, step 1: what impulse, as a vector in the world, do the three accumulated numbers make?
  // L7.5, step 2: who gets it, and who its opposite?
  // See README.md, L7.5.
  throw NotImplemented("L7.5");
}

void solve_normal([[maybe_unused]] ContactConstraint& constraint, [[maybe_unused]] SolverBody& a,
                  [[maybe_unused]] SolverBody& b, [[maybe_unused]] const ContactStep& step) {
  // L7.6, step 1: how far apart are the surfaces by now? The constraint tells the start of the step, the
  //               bodies what they moved and turned since.
  // L7.6, step 2: Jv, and the bias b for this separation.
  // L7.6, step 3: λ = −m·(Jv + b), softened by the two scales of the bias.
  // L7.6, step 4: accumulate, clamp the sum, apply the difference.
  // See README.md, L7.6.
  throw NotImplemented("L7.6");
}

void solve_friction([[maybe_unused]] ContactConstraint& constraint, [[maybe_unused]] SolverBody& a,
                    [[maybe_unused]] SolverBody& b) {
  // L7.7, step 1: how fast does the contact slip along u and along v?
  // L7.7, step 2: the pair of impulses that stops both, from the 2 × 2 mass, added to what the constraint
  //               has accumulated.
  // L7.7, step 3: the pair is a vector in the tangent plane. How long may it be?
  // L7.7, step 4: a pair that is too long slides. Which way must friction point then, and does your
  //               pair point there, if the mass is larger along u than along v?
  // L7.7, step 5: apply what is new.
  // See README.md, L7.7.
  throw NotImplemented("L7.7");
}

void solve_contacts([[maybe_unused]] std::span<ContactConstraint> constraints,
                    [[maybe_unused]] std::span<SolverBody> bodies,
                    [[maybe_unused]] const ContactStep& step) {
  // L7.8, step 1: visit every constraint once, in order, with its two bodies: normal, then friction.
  // L7.8, step 2: backwards, do exactly the reverse: what comes first, which constraint, and in it what?
  // See README.md, L7.8.
  throw NotImplemented("L7.8");
}

void apply_restitution([[maybe_unused]] std::span<ContactConstraint> constraints,
                       [[maybe_unused]] std::span<SolverBody> bodies,
                       [[maybe_unused]] const ContactStep& step) {
  // L7.9, step 1: has any constraint been hit, hard enough to bounce? If not, only step 4 is left.
  // L7.9, step 2: which constraints are in touch, what normal velocity should each of them have, whether it
  //               bounces or not, and which impulse gives it to them?
  // L7.9, step 3: several corners of one body pull at each other: sweep as often as the step says.
  // L7.9, step 4: when all is done, remember which constraints have had their impact.
  // See README.md, L7.9.
  throw NotImplemented("L7.9");
}

}  // namespace cs550
