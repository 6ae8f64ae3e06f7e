/// @file constraint_solver.cpp
/// Lab 7, reference, L7.1 to L7.4: what a constraint asks for, and what stays the same during a step.

#include "cs550/constraint_solver.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// J·M⁻¹·Kᵀ for two constraints of the same contact: how much an impulse along k changes the velocity
/// along j.
Real coupling(const ContactJacobian& j, const ContactJacobian& k, const SolverBody& a,
              const SolverBody& b) {
  return a.inverse_mass * j.linear_a.dot(k.linear_a) +
         j.angular_a.dot(a.world_inverse_inertia * k.angular_a) +
         b.inverse_mass * j.linear_b.dot(k.linear_b) +
         j.angular_b.dot(b.world_inverse_inertia * k.angular_b);
}

/// (JM⁻¹Jᵀ)⁻¹ for the two tangents together; 0 for two immovable bodies.
Mat2 tangent_constraint_mass(const ContactConstraint& constraint, const SolverBody& a,
                             const SolverBody& b) {
  const ContactJacobian ju = contact_jacobian(constraint.u, constraint.r_a, constraint.r_b);
  const ContactJacobian jv = contact_jacobian(constraint.v(), constraint.r_a, constraint.r_b);
  const Real uu = coupling(ju, ju, a, b);
  const Real uv = coupling(ju, jv, a, b);
  const Real vv = coupling(jv, jv, a, b);
  const Real determinant = uu * vv - uv * uv;
  if (determinant <= 0) return Mat2::Zero();
  Mat2 inverse;
  inverse << vv, -uv, -uv, uu;
  return inverse / determinant;
}

bool bounces(const ContactConstraint& constraint, Real threshold) {
  return constraint.restitution > 0 && constraint.approach_velocity < -threshold;
}

}  // namespace

ContactJacobian contact_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  return {-direction, -r_a.cross(direction), direction, r_b.cross(direction)};
}

Real constraint_mass(const ContactJacobian& jacobian, const SolverBody& a, const SolverBody& b) {
  const Real inverse = coupling(jacobian, jacobian, a, b);
  return inverse > 0 ? 1 / inverse : 0;
}

ContactBias contact_bias(const ContactConstraint& constraint, Real separation,
                         const ContactStep& step) {
  ContactBias bias;
  if (separation > 0) {
    bias.velocity = separation / step.h;
  } else if (step.use_bias && step.model == ContactModel::Soft) {
    bias.velocity = std::max(constraint.softness.bias_rate * separation, -step.max_push_speed);
    bias.mass_scale = constraint.softness.mass_scale;
    bias.impulse_scale = constraint.softness.impulse_scale;
  } else if (step.use_bias) {
    const Real excess = std::min(separation + step.slop, Real(0));
    bias.velocity = std::max(step.baumgarte / step.h * excess, -step.max_push_speed);
  }
  if (step.use_bias && step.model == ContactModel::Baumgarte &&
      bounces(constraint, step.restitution_threshold)) {
    bias.velocity = std::min(bias.velocity, constraint.restitution * constraint.approach_velocity);
  }
  return bias;
}

void prepare_contacts(std::span<ContactConstraint> constraints, std::span<const SolverBody> bodies,
                      const ContactStep& step) {
  for (ContactConstraint& constraint : constraints) {
    const SolverBody& a = bodies[constraint.body_a];
    const SolverBody& b = bodies[constraint.body_b];
    constraint.normal_mass =
        constraint_mass(contact_jacobian(constraint.n, constraint.r_a, constraint.r_b), a, b);
    constraint.tangent_mass = tangent_constraint_mass(constraint, a, b);
    const bool with_immovable = a.inverse_mass == 0 || b.inverse_mass == 0;
    constraint.softness = with_immovable ? step.soft_static : step.soft;
  }
}

}  // namespace cs550
