#include "lab7_constraint_solver/dense_contact.hpp"

#include <Eigen/LU>

namespace cs550::test {

double relative_speed(const Vec12& velocity, const Vec3& direction, const Vec3& r_a,
                      const Vec3& r_b) {
  const Eigen::Vector3d w_a = velocity.segment<3>(3);
  const Eigen::Vector3d w_b = velocity.segment<3>(9);
  const Eigen::Vector3d at_a = velocity.segment<3>(0) + w_a.cross(wide(r_a));
  const Eigen::Vector3d at_b = velocity.segment<3>(6) + w_b.cross(wide(r_b));
  return wide(direction).dot(at_b - at_a);
}

Vec12 dense_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  Vec12 jacobian;
  for (int i = 0; i < 12; ++i) {
    jacobian[i] = relative_speed(Vec12::Unit(i), direction, r_a, r_b);
  }
  return jacobian;
}

Mat12 dense_inverse_mass(const SolverBody& a, const SolverBody& b) {
  Mat12 inverse = Mat12::Zero();
  inverse.block<3, 3>(0, 0).diagonal().setConstant(static_cast<double>(a.inverse_mass));
  inverse.block<3, 3>(3, 3) = a.world_inverse_inertia.cast<double>();
  inverse.block<3, 3>(6, 6).diagonal().setConstant(static_cast<double>(b.inverse_mass));
  inverse.block<3, 3>(9, 9) = b.world_inverse_inertia.cast<double>();
  return inverse;
}

Vec12 stacked(const SolverBody& a, const SolverBody& b) {
  Vec12 velocity;
  velocity << wide(a.v), wide(a.w), wide(b.v), wide(b.w);
  return velocity;
}

SolverBody random_body(Random& random, Real size) {
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

ContactConstraint random_constraint(Random& random, Real size) {
  ContactConstraint constraint;
  constraint.body_a = 0;
  constraint.body_b = 1;
  constraint.n = random.unit_vector();
  constraint.u = any_perpendicular(constraint.n);
  constraint.r_a = random.point_in_box(Vec3::Constant(size));
  constraint.r_b = random.point_in_box(Vec3::Constant(size));
  return constraint;
}

Eigen::Matrix<double, 3, 12> dense_jacobians(const ContactConstraint& constraint) {
  Eigen::Matrix<double, 3, 12> j;
  j.row(0) = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b).transpose();
  j.row(1) = dense_jacobian(constraint.u, constraint.r_a, constraint.r_b).transpose();
  j.row(2) =
      dense_jacobian(constraint.n.cross(constraint.u), constraint.r_a, constraint.r_b).transpose();
  return j;
}

Eigen::Matrix3d dense_inverse_contact_mass(const ContactConstraint& constraint, const SolverBody& a,
                                           const SolverBody& b) {
  const Eigen::Matrix<double, 3, 12> j = dense_jacobians(constraint);
  // Sum by sum: students wait seconds for the compilation of a general product.
  const Eigen::Matrix<double, 3, 12> scaled = j.lazyProduct(dense_inverse_mass(a, b));
  return scaled.lazyProduct(j.transpose());
}

void prepare_densely(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b) {
  const Eigen::Matrix3d k = dense_inverse_contact_mass(constraint, a, b);
  const Eigen::Matrix2d tangents = k.bottomRightCorner<2, 2>();
  constraint.normal_mass = static_cast<Real>(1 / k(0, 0));
  constraint.tangent_mass = tangents.inverse().cast<Real>();
}

Meeting random_meeting(Random& random, Real size) {
  Meeting meeting;
  meeting.a = random_body(random, size);
  meeting.b = random_body(random, size);
  meeting.constraint = random_constraint(random, size);
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
  return meeting;
}

void make_approach(Meeting& meeting) {
  if (meeting.contact_velocity()[0] < 0) return;
  meeting.constraint.n = -meeting.constraint.n;
  prepare_densely(meeting.constraint, meeting.a, meeting.b);
}

Meeting landing(Real mass, const Vec3& velocity) {
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

Vec12 Meeting::velocity() const { return stacked(a, b); }

Eigen::Vector3d Meeting::contact_velocity() const {
  return dense_jacobians(constraint) * velocity();
}

Eigen::Vector3d Meeting::impulses() const {
  return Vec3(constraint.normal_impulse, constraint.tangent_impulse.x(),
              constraint.tangent_impulse.y())
      .cast<double>();
}

Vec12 Meeting::velocity_after(const Eigen::Vector3d& impulses) const {
  return velocity() +
         dense_inverse_mass(a, b) * (dense_jacobians(constraint).transpose() * impulses);
}

Eigen::Matrix<double, 6, 1> Meeting::momentum() const {
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

}  // namespace cs550::test
