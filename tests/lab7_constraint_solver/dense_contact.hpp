#pragma once
/// @file dense_contact.hpp
/// The oracle of lab 7: contacts as dense matrices in double precision, derived only from the
/// definition of the relative velocity.

#include <Eigen/Core>
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
double relative_speed(const Vec12& velocity, const Vec3& direction, const Vec3& r_a,
                      const Vec3& r_b);

/// J from the definition, as the contribution of each unit velocity.
Vec12 dense_jacobian(const Vec3& direction, const Vec3& r_a, const Vec3& r_b);

Mat12 dense_inverse_mass(const SolverBody& a, const SolverBody& b);

Vec12 stacked(const SolverBody& a, const SolverBody& b);

/// A body of density 1000 and the inertia of a box of random proportions, moving at random.
SolverBody random_body(Random& random, Real size = 1);

inline SolverBody immovable_body() { return {}; }

/// A contact in a random direction at random offsets, not prepared.
ContactConstraint random_constraint(Random& random, Real size = 1);

/// The rows of J for n, u and v.
Eigen::Matrix<double, 3, 12> dense_jacobians(const ContactConstraint& constraint);

/// J·M⁻¹·Jᵀ along n, u and v.
Eigen::Matrix3d dense_inverse_contact_mass(const ContactConstraint& constraint, const SolverBody& a,
                                           const SolverBody& b);

/// Replaces prepare_contacts() for a rigid contact, so that later steps can be tested without it.
void prepare_densely(ContactConstraint& constraint, const SolverBody& a, const SolverBody& b);

/// Two bodies with a contact.
struct Meeting {
  SolverBody a;
  SolverBody b;
  ContactConstraint constraint;

  Vec12 velocity() const;
  /// The relative velocity along n, u and v.
  Eigen::Vector3d contact_velocity() const;
  Eigen::Vector3d impulses() const;
  /// V + M⁻¹Jᵀλ for impulses along n, u and v.
  Vec12 velocity_after(const Eigen::Vector3d& impulses) const;
  /// P, and L about the contact point.
  Eigen::Matrix<double, 6, 1> momentum() const;
};

/// A prepared contact between two bodies with random motion.
Meeting random_meeting(Random& random, Real size = 1);

/// Turns a meeting round, so that the bodies approach.
void make_approach(Meeting& meeting);

/// A floor and a unit cube above it. Its centre is directly above the contact, so that it lands
/// without turning.
Meeting landing(Real mass, const Vec3& velocity);

/// A substep without softness and without slop.
inline ContactStep rigid_step(Real h = Real(1) / 240) {
  ContactStep step;
  step.h = h;
  return step;
}

}  // namespace cs550::test
