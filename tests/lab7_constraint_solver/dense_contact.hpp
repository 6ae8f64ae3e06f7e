#pragma once
/// @file dense_contact.hpp
/// The oracle of lab 7: contacts as dense matrices in double precision, derived only from the
/// definition of the relative velocity.

#include <Eigen/Core>
#include <Eigen/LU>
#include <span>
#include <vector>

#include "cs550/constraint_solver.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"

namespace cs550::test {

/// Roundings of float in a few products and sums: relative to the largest term, or in m/s at speeds
/// of some m/s.
inline constexpr double rounding = 5e-5;

/// Velocities of two bodies, stacked: v_A, ω_A, v_B, ω_B.
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

inline Eigen::Vector3d wide(const Vec3& v) { return v.cast<double>(); }

/// d·(v_B + ω_B × r_B − v_A − ω_A × r_A).
inline double relative_speed(const Vec12& velocity, const Vec3& direction, const Vec3& r_a,
                             const Vec3& r_b) {
  const Eigen::Vector3d w_a = velocity.segment<3>(3);
  const Eigen::Vector3d w_b = velocity.segment<3>(9);
  const Eigen::Vector3d at_a = velocity.segment<3>(0) + w_a.cross(wide(r_a));
  const Eigen::Vector3d at_b = velocity.segment<3>(6) + w_b.cross(wide(r_b));
  return wide(direction).dot(at_b - at_a);
}

/// J from the definition, as the contribution of each unit velocity.
inline Vec12 dense_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  Vec12 jacobian;
  for (int i = 0; i < 12; ++i) {
    jacobian[i] = relative_speed(Vec12::Unit(i), direction, r_a, r_b);
  }
  return jacobian;
}

inline Mat12 dense_inverse_mass(const SolverBody& a, const SolverBody& b) {
  Mat12 inverse = Mat12::Zero();
  inverse.block<3, 3>(0, 0).diagonal().setConstant(static_cast<double>(a.inverse_mass));
  inverse.block<3, 3>(3, 3) = a.world_inverse_inertia.cast<double>();
  inverse.block<3, 3>(6, 6).diagonal().setConstant(static_cast<double>(b.inverse_mass));
  inverse.block<3, 3>(9, 9) = b.world_inverse_inertia.cast<double>();
  return inverse;
}

inline Vec12 stacked(const SolverBody& a, const SolverBody& b) {
  Vec12 velocity;
  velocity << wide(a.v), wide(a.w), wide(b.v), wide(b.w);
  return velocity;
}

/// A body of density 1000 and the inertia of a box of random proportions, moving at random.
inline SolverBody random_body(Random& random, Real size = 1) {
  const Vec3 half =
      size * Vec3(random.real(Real(0.1), 1), random.real(Real(0.1), 1), random.real(Real(0.1), 1));
  const Real mass = 8000 * half.prod();
  const Vec3 squares = half.cwiseProduct(half);
  const Vec3 inertia = mass / 3 * (Vec3::Constant(squares.sum()) - squares);
  const Quat orientation = random.orientation();
  const Mat3 rotation = orientation.toRotationMatrix();
  SolverBody body;
  body.inverse_mass = 1 / mass;
  body.world_inverse_inertia =
      rotation * inertia.cwiseInverse().asDiagonal() * rotation.transpose();
  body.v = size * random.point_in_box(Vec3::Constant(3));
  body.w = random.point_in_box(Vec3::Constant(5));
  return body;
}

inline SolverBody immovable_body() { return {}; }

/// A contact in a random direction at random offsets, not prepared.
inline ContactConstraint random_constraint(Random& random, Real size = 1) {
  ContactConstraint constraint;
  constraint.body_a = 0;
  constraint.body_b = 1;
  constraint.n = random.unit_vector();
  constraint.u = any_perpendicular(constraint.n);
  constraint.r_a = random.point_in_box(Vec3::Constant(size));
  constraint.r_b = random.point_in_box(Vec3::Constant(size));
  return constraint;
}

/// The rows of J for n, u and v.
inline Eigen::Matrix<double, 3, 12> dense_jacobians(const ContactConstraint& constraint) {
  Eigen::Matrix<double, 3, 12> j;
  j.row(0) = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b).transpose();
  j.row(1) = dense_jacobian(constraint.u, constraint.r_a, constraint.r_b).transpose();
  j.row(2) =
      dense_jacobian(constraint.n.cross(constraint.u), constraint.r_a, constraint.r_b).transpose();
  return j;
}

/// J·M⁻¹·Jᵀ along n, u and v.
inline Eigen::Matrix3d dense_inverse_contact_mass(const ContactConstraint& constraint,
                                                  const SolverBody& a, const SolverBody& b) {
  const Eigen::Matrix<double, 3, 12> j = dense_jacobians(constraint);
  // Sum by sum: students wait seconds for the compilation of a general product.
  const Eigen::Matrix<double, 3, 12> scaled = j.lazyProduct(dense_inverse_mass(a, b));
  return scaled.lazyProduct(j.transpose());
}

/// Replaces prepare_contacts() for a rigid contact, so that later steps can be tested without it.
inline void prepare_densely(ContactConstraint& constraint, const SolverBody& a,
                            const SolverBody& b) {
  const Eigen::Matrix3d k = dense_inverse_contact_mass(constraint, a, b);
  const Eigen::Matrix2d tangents = k.bottomRightCorner<2, 2>();
  constraint.normal_mass = static_cast<Real>(1 / k(0, 0));
  constraint.tangent_mass = tangents.inverse().cast<Real>();
}

/// Two bodies with a contact.
struct Meeting {
  SolverBody a;
  SolverBody b;
  ContactConstraint constraint;

  Vec12 velocity() const { return stacked(a, b); }
  /// The relative velocity along n, u and v.
  Eigen::Vector3d contact_velocity() const { return dense_jacobians(constraint) * velocity(); }
  Eigen::Vector3d impulses() const {
    return Vec3(constraint.normal_impulse, constraint.tangent_impulse.x(),
                constraint.tangent_impulse.y())
        .cast<double>();
  }
  /// V + M⁻¹Jᵀλ for impulses along n, u and v.
  Vec12 velocity_after(const Eigen::Vector3d& impulses) const {
    return velocity() +
           dense_inverse_mass(a, b) * (dense_jacobians(constraint).transpose() * impulses);
  }
  /// P, and L about the contact point.
  Eigen::Matrix<double, 6, 1> momentum() const {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    const auto add = [&sum](const SolverBody& body, const Vec3& r) {
      const Eigen::Vector3d p = wide(body.v) / static_cast<double>(body.inverse_mass);
      const Eigen::Matrix3d inverse_inertia = body.world_inverse_inertia.cast<double>();
      sum.head<3>() += p;
      sum.tail<3>() += p.cross(wide(r)) + inverse_inertia.inverse() * wide(body.w);
    };
    add(a, constraint.r_a);
    add(b, constraint.r_b);
    return sum;
  }
};

/// A prepared contact between two bodies with random motion.
inline Meeting random_meeting(Random& random, Real size = 1) {
  Meeting meeting;
  meeting.a = random_body(random, size);
  meeting.b = random_body(random, size);
  meeting.constraint = random_constraint(random, size);
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
  return meeting;
}

/// Turns a meeting round, so that the bodies approach.
inline void make_approach(Meeting& meeting) {
  if (meeting.contact_velocity()[0] < 0) return;
  meeting.constraint.n = -meeting.constraint.n;
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
}

/// A floor and a unit cube above it. Its centre is directly above the contact, so that it lands
/// without turning.
inline Meeting landing(Real mass, const Vec3& velocity) {
  Meeting meeting;
  meeting.b.inverse_mass = 1 / mass;
  meeting.b.world_inverse_inertia = 6 / mass * Mat3::Identity();
  meeting.b.v = velocity;
  meeting.constraint.body_a = 0;
  meeting.constraint.body_b = 1;
  meeting.constraint.n = Vec3::UnitZ();
  meeting.constraint.u = Vec3::UnitX();
  meeting.constraint.r_b = Vec3(0, 0, Real(-0.5));
  meeting.constraint.normal_mass = mass;
  // A tangential impulse also turns the body: 1/m + r²/I = (1 + 0.25 · 6)/m.
  meeting.constraint.tangent_mass = mass / Real(2.5) * Mat2::Identity();
  return meeting;
}

/// A substep without softness and without slop.
inline ContactStep rigid_step(Real h = Real(1) / 240) {
  ContactStep step;
  step.h = h;
  return step;
}

}  // namespace cs550::test
