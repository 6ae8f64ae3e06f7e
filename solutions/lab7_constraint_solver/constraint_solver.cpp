/// @file constraint_solver.cpp
/// Lab 7, reference, L7.1 to L7.4: what a row asks for, and what stays the same during a step.

#include "cs550/constraint_solver.hpp"

#include <algorithm>

namespace cs550 {

namespace {

/// J·M⁻¹·Kᵀ for two rows of the same contact: how much an impulse along k changes the velocity
/// along j.
Real couple(const ContactJacobian& j, const ContactJacobian& k, const BodyVelocity& a,
            const BodyVelocity& b) {
  return a.inverse_mass * j.linear_a.dot(k.linear_a) +
         j.angular_a.dot(a.world_inverse_inertia * k.angular_a) +
         b.inverse_mass * j.linear_b.dot(k.linear_b) +
         j.angular_b.dot(b.world_inverse_inertia * k.angular_b);
}

/// (JM⁻¹Jᵀ)⁻¹ for the two tangents together; 0 for two immovable bodies.
Mat2 tangent_constraint_mass(const ContactRow& row, const BodyVelocity& a, const BodyVelocity& b) {
  const ContactJacobian ju = contact_jacobian(row.u, row.r_a, row.r_b);
  const ContactJacobian jv = contact_jacobian(row.v(), row.r_a, row.r_b);
  const Real uu = couple(ju, ju, a, b);
  const Real uv = couple(ju, jv, a, b);
  const Real vv = couple(jv, jv, a, b);
  const Real determinant = uu * vv - uv * uv;
  if (determinant <= 0) return Mat2::Zero();
  Mat2 inverse;
  inverse << vv, -uv, -uv, uu;
  return inverse / determinant;
}

bool bounces(const ContactRow& row, Real threshold) {
  return row.restitution > 0 && row.approach_velocity < -threshold;
}

}  // namespace

ContactJacobian contact_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  return {-direction, -r_a.cross(direction), direction, r_b.cross(direction)};
}

Real constraint_mass(const ContactJacobian& jacobian, const BodyVelocity& a,
                     const BodyVelocity& b) {
  const Real inverse = couple(jacobian, jacobian, a, b);
  return inverse > 0 ? 1 / inverse : 0;
}

ContactBias contact_bias(const ContactRow& row, Real separation, const ContactStep& step) {
  ContactBias bias;
  if (separation > 0) {
    bias.velocity = separation / step.h;
  } else if (step.use_bias && step.model == ContactModel::Soft) {
    bias.velocity = std::max(row.softness.bias_rate * separation, -step.max_push_speed);
    bias.mass_scale = row.softness.mass_scale;
    bias.impulse_scale = row.softness.impulse_scale;
  } else if (step.use_bias) {
    const Real excess = std::min(separation + step.slop, Real(0));
    bias.velocity = std::max(step.baumgarte / step.h * excess, -step.max_push_speed);
  }
  if (step.use_bias && step.model == ContactModel::Baumgarte &&
      bounces(row, step.restitution_threshold)) {
    bias.velocity = std::min(bias.velocity, row.restitution * row.approach_velocity);
  }
  return bias;
}

void prepare_contacts(std::span<ContactRow> rows, std::span<const BodyVelocity> bodies,
                      const ContactStep& step) {
  for (ContactRow& row : rows) {
    const BodyVelocity& a = bodies[static_cast<std::size_t>(row.body_a)];
    const BodyVelocity& b = bodies[static_cast<std::size_t>(row.body_b)];
    row.normal_mass = constraint_mass(contact_jacobian(row.n, row.r_a, row.r_b), a, b);
    row.tangent_mass = tangent_constraint_mass(row, a, b);
    const bool with_immovable = a.inverse_mass == 0 || b.inverse_mass == 0;
    row.softness = with_immovable ? step.soft_static : step.soft;
  }
}

}  // namespace cs550
