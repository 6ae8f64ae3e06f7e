/// @file naive_solver.cpp
/// Lab 6: the naive solver. The handout is README.md in this folder. The contract of each function
/// is in framework/include/cs550/naive_solver.hpp, bodies and constraints in solver_body.hpp and
/// contact_constraint.hpp in the same folder.

#include "cs550/naive_solver.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: a glider on an air track hits the buffer at the end of the track. One body, one
/// direction, no rotation. A collision of two bodies raises the same three questions.
struct Glider {
  Real mass;      // kg
  Real velocity;  // m/s, positive towards the buffer
};

/// Returns the impulse of the buffer on the glider (N·s).
[[maybe_unused]] Real hit_buffer(Glider& glider, Real restitution) {
  // 1. Does it approach? A glider that is moving away already must not be hit again.
  if (glider.velocity <= 0) return 0;

  // 2. Which change of velocity do we want? Stopping the glider takes −v. Throwing it back at e·v
  //    takes another −e·v.
  const Real change = -(1 + restitution) * glider.velocity;

  // 3. Which impulse causes that change? Mass is the impulse per change of velocity.
  const Real impulse = glider.mass * change;
  glider.velocity += impulse / glider.mass;
  return impulse;
}

}  // namespace

Real effective_mass([[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b,
                    [[maybe_unused]] const Vec3& r_a, [[maybe_unused]] const Vec3& r_b,
                    [[maybe_unused]] const Vec3& direction) {
  // L6.1: By how much does a unit impulse change the velocity of each contact point? The body also
  // rotates.
  throw NotImplemented("L6.1");
}

Real normal_velocity([[maybe_unused]] const SolverBody& a, [[maybe_unused]] const SolverBody& b,
                     [[maybe_unused]] const Vec3& r_a, [[maybe_unused]] const Vec3& r_b,
                     [[maybe_unused]] const Vec3& n) {
  // L6.2: The contact point is a point of each body. How fast does B's move away from A's?
  throw NotImplemented("L6.2");
}

void resolve_contacts_naive([[maybe_unused]] std::span<ContactConstraint> constraints,
                            [[maybe_unused]] std::span<SolverBody> bodies) {
  // L6.3: Start without restitution. Which contacts need no impulse?
  // L6.4: Then let the bodies bounce.
  throw NotImplemented("L6.3");
}

}  // namespace cs550
