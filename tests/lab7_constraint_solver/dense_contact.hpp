#pragma once
/// @file dense_contact.hpp
/// The oracle of lab 7: contacts as dense matrices in double precision, from the definition of the
/// relative velocity and nothing else.

#include <Eigen/Core>
#include <Eigen/LU>
#include <span>
#include <vector>

#include "cs550/constraint_solver.hpp"
#include "support/random.hpp"

namespace cs550::test {

/// Velocities of two bodies, stacked: v_A, ω_A, v_B, ω_B.
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

inline Eigen::Vector3d wide(const Vec3& v) { return v.cast<double>(); }

/// d·(v_B + ω_B × r_B − v_A − ω_A × r_A), as it stands.
inline double relative_speed(const Vec12& velocity, const Vec3& direction, const Vec3& r_a,
                             const Vec3& r_b) {
  const Eigen::Vector3d w_a = velocity.segment<3>(3);
  const Eigen::Vector3d w_b = velocity.segment<3>(9);
  const Eigen::Vector3d at_a = velocity.segment<3>(0) + w_a.cross(wide(r_a));
  const Eigen::Vector3d at_b = velocity.segment<3>(6) + w_b.cross(wide(r_b));
  return wide(direction).dot(at_b - at_a);
}

/// J from the definition: what each unit velocity contributes.
inline Vec12 dense_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  Vec12 jacobian;
  for (int i = 0; i < 12; ++i) {
    jacobian[i] = relative_speed(Vec12::Unit(i), direction, r_a, r_b);
  }
  return jacobian;
}

inline Mat12 dense_inverse_mass(const BodyVelocity& a, const BodyVelocity& b) {
  Mat12 inverse = Mat12::Zero();
  inverse.block<3, 3>(0, 0).diagonal().setConstant(static_cast<double>(a.inverse_mass));
  inverse.block<3, 3>(3, 3) = a.world_inverse_inertia.cast<double>();
  inverse.block<3, 3>(6, 6).diagonal().setConstant(static_cast<double>(b.inverse_mass));
  inverse.block<3, 3>(9, 9) = b.world_inverse_inertia.cast<double>();
  return inverse;
}

inline Vec12 stacked(const BodyVelocity& a, const BodyVelocity& b) {
  Vec12 velocity;
  velocity << wide(a.v), wide(a.w), wide(b.v), wide(b.w);
  return velocity;
}

/// A body of density 1000 and the inertia of a box of random proportions, moving at random.
inline BodyVelocity random_body(Random& random, Real size = 1) {
  const Vec3 half =
      size * Vec3(random.real(Real(0.1), 1), random.real(Real(0.1), 1), random.real(Real(0.1), 1));
  const Real mass = 8000 * half.prod();
  const Vec3 squares = half.cwiseProduct(half);
  const Vec3 inertia = mass / 3 * (Vec3::Constant(squares.sum()) - squares);
  const Quat orientation = random.orientation();
  const Mat3 rotation = orientation.toRotationMatrix();
  BodyVelocity body;
  body.inverse_mass = 1 / mass;
  body.world_inverse_inertia =
      rotation * inertia.cwiseInverse().asDiagonal() * rotation.transpose();
  body.v = size * random.point_in_box(Vec3::Constant(3));
  body.w = random.point_in_box(Vec3::Constant(5));
  return body;
}

inline BodyVelocity immovable_body() { return {}; }

/// A contact in a random direction at random offsets; nothing prepared.
inline ContactRow random_row(Random& random, Real size = 1) {
  ContactRow row;
  row.body_a = 0;
  row.body_b = 1;
  row.n = random.unit_vector();
  row.u = any_perpendicular(row.n);
  row.r_a = random.point_in_box(Vec3::Constant(size));
  row.r_b = random.point_in_box(Vec3::Constant(size));
  return row;
}

/// Rows of n, u and v.
inline Eigen::Matrix<double, 3, 12> dense_jacobians(const ContactRow& row) {
  Eigen::Matrix<double, 3, 12> j;
  j.row(0) = dense_jacobian(row.n, row.r_a, row.r_b).transpose();
  j.row(1) = dense_jacobian(row.u, row.r_a, row.r_b).transpose();
  j.row(2) = dense_jacobian(row.n.cross(row.u), row.r_a, row.r_b).transpose();
  return j;
}

/// Does what prepare_contacts() does for a rigid contact, so that later steps need not wait for it.
inline void prepare_densely(ContactRow& row, const BodyVelocity& a, const BodyVelocity& b) {
  const Eigen::Matrix<double, 3, 12> j = dense_jacobians(row);
  const Eigen::Matrix3d k = j * dense_inverse_mass(a, b) * j.transpose();
  const Eigen::Matrix2d tangents = k.bottomRightCorner<2, 2>();
  row.normal_mass = static_cast<Real>(1 / k(0, 0));
  row.tangent_mass = tangents.inverse().cast<Real>();
}

/// Two bodies that meet.
struct Meeting {
  BodyVelocity a;
  BodyVelocity b;
  ContactRow row;

  Vec12 velocity() const { return stacked(a, b); }
  /// The relative velocity along n, u and v.
  Eigen::Vector3d contact_velocity() const { return dense_jacobians(row) * velocity(); }
  Eigen::Vector3d impulses() const {
    return Vec3(row.normal_impulse, row.tangent_impulse.x(), row.tangent_impulse.y())
        .cast<double>();
  }
  /// V + M⁻¹Jᵀλ for impulses along n, u and v.
  Vec12 velocity_after(const Eigen::Vector3d& impulses) const {
    return velocity() + dense_inverse_mass(a, b) * dense_jacobians(row).transpose() * impulses;
  }
  /// P, and L about the contact point.
  Eigen::Matrix<double, 6, 1> momentum() const {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    const auto add = [&sum](const BodyVelocity& body, const Vec3& r) {
      const Eigen::Vector3d p = wide(body.v) / static_cast<double>(body.inverse_mass);
      const Eigen::Matrix3d inverse_inertia = body.world_inverse_inertia.cast<double>();
      sum.head<3>() += p;
      sum.tail<3>() += p.cross(wide(r)) + inverse_inertia.inverse() * wide(body.w);
    };
    add(a, row.r_a);
    add(b, row.r_b);
    return sum;
  }
};

/// A prepared meeting in which both bodies move at random.
inline Meeting random_meeting(Random& random, Real size = 1) {
  Meeting meeting;
  meeting.a = random_body(random, size);
  meeting.b = random_body(random, size);
  meeting.row = random_row(random, size);
  prepare_densely(meeting.row, meeting.a, meeting.b);
  return meeting;
}

/// Turns a meeting round, so that the bodies approach.
inline void make_approach(Meeting& meeting) {
  if (meeting.contact_velocity()[0] < 0) return;
  meeting.row.n = -meeting.row.n;
  prepare_densely(meeting.row, meeting.a, meeting.b);
}

/// A floor and a body above it, a unit cube whose centre is straight over the contact: it lands without
/// turning.
inline Meeting landing(Real mass, const Vec3& velocity) {
  Meeting meeting;
  meeting.b.inverse_mass = 1 / mass;
  meeting.b.world_inverse_inertia = 6 / mass * Mat3::Identity();
  meeting.b.v = velocity;
  meeting.row.body_a = 0;
  meeting.row.body_b = 1;
  meeting.row.n = Vec3::UnitZ();
  meeting.row.u = Vec3::UnitX();
  meeting.row.r_b = Vec3(0, 0, Real(-0.5));
  meeting.row.normal_mass = mass;
  // Along the floor the body also turns: 1/m + r²/I = (1 + 0.25 · 6)/m.
  meeting.row.tangent_mass = mass / Real(2.5) * Mat2::Identity();
  return meeting;
}

/// A substep without softness and without slop.
inline ContactStep rigid_step(Real h = Real(1) / 240) {
  ContactStep step;
  step.h = h;
  return step;
}

}  // namespace cs550::test
