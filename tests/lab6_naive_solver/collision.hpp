#pragma once
/// @file collision.hpp
/// Bodies and constraints for the tests of lab 6, and the same collision as matrices in double
/// precision: V = [v_A, ω_A, v_B, ω_B], J = [−d, −r_A × d, d, r_B × d], M⁻¹ of 12 × 12.

#include <Eigen/LU>
#include <vector>

#include "cs550/naive_solver.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"

namespace cs550::test {

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// A box of uniform density at rest: I⁻¹ = 3/m·diag(1/(b² + c²), …) for half-extents a, b, c.
inline SolverBody movable(Real mass, const Vec3& half_extents,
                          const Quat& orientation = Quat::Identity()) {
  const Vec3 square = half_extents.cwiseProduct(half_extents);
  const Vec3 inertia = mass / 3 * (Vec3::Constant(square.sum()) - square);
  const Mat3 rotation = orientation.toRotationMatrix();
  const Mat3 inverse_inertia = inertia.cwiseInverse().asDiagonal();
  SolverBody body;
  body.inverse_mass = 1 / mass;
  body.world_inverse_inertia = rotation * inverse_inertia * rotation.transpose();
  return body;
}

/// A contact between bodies 0 and 1, or others.
inline ContactConstraint touching(const Vec3& n, const Vec3& r_a, const Vec3& r_b,
                                  Real restitution = 0, Index body_a = 0, Index body_b = 1) {
  ContactConstraint constraint;
  constraint.body_a = body_a;
  constraint.body_b = body_b;
  constraint.n = n;
  constraint.u = any_perpendicular(n);
  constraint.r_a = r_a;
  constraint.r_b = r_b;
  constraint.restitution = restitution;
  return constraint;
}

/// Two boxes and a contact between them.
struct Collision {
  SolverBody a;
  SolverBody b;
  ContactConstraint constraint;
};

/// Random approaching boxes of a given size (m). Their masses differ by up to a factor of 100.
inline Collision random_collision(Random& random, Real size, Real restitution = 0) {
  const auto random_box = [&random, size] {
    const Vec3 shape = Vec3::Constant(Real(0.55)) + random.point_in_box(Vec3::Constant(Real(0.45)));
    const Real mass = random.real(1, 100) * size * size * size;
    SolverBody body = movable(mass, size * shape, random.orientation());
    body.v = size * random.point_in_box(Vec3(3, 3, 3));
    body.w = random.point_in_box(Vec3(3, 3, 3));
    return body;
  };
  Collision collision;
  collision.a = random_box();
  collision.b = random_box();
  const Vec3 r_a = size * random.unit_vector();
  const Vec3 r_b = size * random.unit_vector();
  const Vec3 n = random.unit_vector();
  const Vec3 apart =
      collision.b.v + collision.b.w.cross(r_b) - collision.a.v - collision.a.w.cross(r_a);
  collision.constraint = touching(apart.dot(n) < 0 ? n : Vec3(-n), r_a, r_b, restitution);
  return collision;
}

inline bool same_motion(const SolverBody& a, const SolverBody& b) {
  return a.v == b.v && a.w == b.w;
}

/// Runs the solver on the contact of a collision.
inline void collide(Collision& collision) {
  std::vector<SolverBody> bodies = {collision.a, collision.b};
  resolve_contacts_naive(std::span(&collision.constraint, 1), bodies);
  collision.a = bodies[0];
  collision.b = bodies[1];
}

inline Vector12 dense_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b) {
  const Eigen::Vector3d d = direction.cast<double>();
  Vector12 jacobian;
  jacobian << -d, -r_a.cast<double>().cross(d), d, r_b.cast<double>().cross(d);
  return jacobian;
}

inline Matrix12 dense_inverse_mass(const SolverBody& a, const SolverBody& b) {
  Matrix12 matrix = Matrix12::Zero();
  matrix.block<3, 3>(0, 0).diagonal().setConstant(a.inverse_mass);
  matrix.block<3, 3>(3, 3) = a.world_inverse_inertia.cast<double>();
  matrix.block<3, 3>(6, 6).diagonal().setConstant(b.inverse_mass);
  matrix.block<3, 3>(9, 9) = b.world_inverse_inertia.cast<double>();
  return matrix;
}

inline Vector12 dense_velocity(const SolverBody& a, const SolverBody& b) {
  Vector12 velocity;
  velocity << a.v.cast<double>(), a.w.cast<double>(), b.v.cast<double>(), b.w.cast<double>();
  return velocity;
}

/// 1/(J·M⁻¹·Jᵀ).
inline double dense_effective_mass(const SolverBody& a, const SolverBody& b, const Vec3& r_a,
                                   const Vec3& r_b, const Vec3& direction) {
  const Vector12 jacobian = dense_jacobian(direction, r_a, r_b);
  return 1 / jacobian.dot(dense_inverse_mass(a, b) * jacobian);
}

/// ½·m·v² + ½·ω·I·ω; 0 for an immovable body.
inline double kinetic_energy(const SolverBody& body) {
  if (body.inverse_mass == 0) return 0;
  const Eigen::Vector3d w = body.w.cast<double>();
  const Eigen::Vector3d spin = body.world_inverse_inertia.cast<double>().inverse() * w;
  return 0.5 * body.v.cast<double>().squaredNorm() / double{body.inverse_mass} + 0.5 * w.dot(spin);
}

inline Eigen::Vector3d linear_momentum(const SolverBody& body) {
  return body.v.cast<double>() / double{body.inverse_mass};
}

/// I·ω + x × m·v about a point, with the centre of mass at x relative to it.
inline Eigen::Vector3d angular_momentum(const SolverBody& body, const Vec3& x) {
  return body.world_inverse_inertia.cast<double>().inverse() * body.w.cast<double>() +
         x.cast<double>().cross(linear_momentum(body));
}

}  // namespace cs550::test
