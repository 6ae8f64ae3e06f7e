// Lab 6: the naive solver. The handout is README.md in this folder; what each function promises is
// in framework/include/cs550/naive_solver.hpp, and the bodies and constraints in contact_constraint.hpp beside it.

#include "cs550/naive_solver.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

// A worked example, complete: a glider on an air track meets the buffer at the end of the track.
// One body, one direction, no turning; a collision of two bodies asks the same three questions.

struct Glider {
  Real mass;      // kg
  Real velocity;  // m/s, positive towards the buffer
};

// Returns the impulse that the buffer gave (N·s).
[[maybe_unused]] Real hit_buffer(Glider& glider, Real restitution) {
  // 1. Does it approach? A glider that is on its way back must not be hit again.
  if (glider.velocity <= 0) return 0;

  // 2. What change of velocity do we want? To stop it takes away all of v, to throw it back with
  //    e·v takes away e·v more.
  const Real change = -(1 + restitution) * glider.velocity;

  // 3. What impulse makes that change? Mass says how much impulse a change of velocity costs.
  const Real impulse = glider.mass * change;
  glider.velocity += impulse / glider.mass;
  return impulse;
}

}  // namespace

Real effective_mass([[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b,
                    [[maybe_unused]] const Vec3& r_a, [[maybe_unused]] const Vec3& r_b,
                    [[maybe_unused]] const Vec3& direction) {
  // L6.1, step 1: how much does a unit impulse change the velocity of each contact point along the
  //               direction, if the bodies could not turn?
  // L6.1, step 2: how much more does it change because they turn? Mind which product comes last.
  // L6.1, step 3: the sum is velocity per impulse; a mass is impulse per velocity.
  // L6.1, step 4: what if neither body can move at all?
  // See README.md, L6.1.
  throw NotImplemented("L6.1");
}

Real normal_velocity([[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b,
                     [[maybe_unused]] const Vec3& r_a, [[maybe_unused]] const Vec3& r_b,
                     [[maybe_unused]] const Vec3& n) {
  // L6.2, step 1: the velocity of the contact point as a point of each body.
  // L6.2, step 2: how fast does B's point move away from A's along n, which points from A to B?
  // See README.md, L6.2.
  throw NotImplemented("L6.2");
}

void resolve_contacts_naive([[maybe_unused]] std::span<ContactConstraint> constraints,
                            [[maybe_unused]] std::span<SolverBody> bodies) {
  // L6.3, step 1: for each constraint, take its two bodies by reference, so that they can change.
  // L6.3, step 2: leave the constraint alone if the bodies do not touch yet, or do not approach.
  // L6.3, step 3: the impulse that stops the approach. Apply it to B, and its opposite to A:
  //               SolverBody::apply() does the turning, too.
  // L6.3, step 4: add it to what the constraint has gathered.
  // L6.4, step 5: let the impulse throw them apart again, as the constraint's restitution demands.
  // See README.md, L6.3 and L6.4.
  throw NotImplemented("L6.3");
}

}  // namespace cs550
