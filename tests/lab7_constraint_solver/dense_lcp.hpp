#pragma once
/// @file dense_lcp.hpp
/// The solution of sequential impulses, by brute force over the active constraints in double:
/// λ ≥ 0, w = J·V' + b ≥ 0, λ·w = 0. Murty, *Linear Complementarity, Linear and
/// Nonlinear Programming* (1988).

#include <Eigen/LU>
#include <optional>

#include "lab7_constraint_solver/dense_contact.hpp"

namespace cs550::test {

/// The normals of some constraints and all their bodies, as matrices.
struct DenseContacts {
  Eigen::MatrixXd jacobian;      ///< one row per contact, six columns per body
  Eigen::MatrixXd inverse_mass;  ///< block diagonal
  Eigen::VectorXd velocity;      ///< v, ω of each body

  DenseContacts(std::span<const ContactConstraint> constraints,
                std::span<const SolverBody> bodies) {
    const auto count = static_cast<Eigen::Index>(constraints.size());
    const auto columns = 6 * static_cast<Eigen::Index>(bodies.size());
    jacobian = Eigen::MatrixXd::Zero(count, columns);
    inverse_mass = Eigen::MatrixXd::Zero(columns, columns);
    velocity = Eigen::VectorXd::Zero(columns);
    for (Eigen::Index k = 0; k < count; ++k) {
      const ContactConstraint& constraint = constraints[k];
      const Vec12 j = dense_jacobian(constraint.n, constraint.r_a, constraint.r_b);
      jacobian.row(k).segment<6>(6 * constraint.body_a) = j.head<6>();
      jacobian.row(k).segment<6>(6 * constraint.body_b) = j.tail<6>();
    }
    for (Eigen::Index i = 0; 6 * i < columns; ++i) {
      const SolverBody& body = bodies[i];
      inverse_mass.block<6, 6>(6 * i, 6 * i) = dense_inverse_mass(body, body).block<6, 6>(0, 0);
      velocity.segment<6>(6 * i) << wide(body.v), wide(body.w);
    }
  }

  Eigen::VectorXd velocity_after(const Eigen::VectorXd& impulses) const {
    return velocity + inverse_mass * (jacobian.transpose() * impulses);
  }
};

/// λ of a small system (up to a dozen constraints) with b = 0. If constraints are redundant, it is
/// one of several solutions with the same V'.
inline std::optional<Eigen::VectorXd> solve_lcp(const DenseContacts& contacts) {
  const Eigen::MatrixXd scaled = contacts.jacobian.lazyProduct(contacts.inverse_mass);
  const Eigen::MatrixXd k = scaled.lazyProduct(contacts.jacobian.transpose());
  const Eigen::VectorXd q = contacts.jacobian * contacts.velocity;
  const double tiny = 1e-9 * q.norm();
  for (unsigned set = 0; set < 1U << q.size(); ++set) {
    // Inactive constraints are replaced by λ = 0.
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(q.size(), q.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      if ((set >> i & 1U) == 0) continue;
      system.row(i) = k.row(i) / k(i, i);
      right[i] = -q[i] / k(i, i);
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> solver(system);
    if (solver.rank() < q.size())
      continue;  // Redundant constraints: a smaller set also has a solution.
    const Eigen::VectorXd impulses = solver.solve(right);
    const Eigen::VectorXd w = k * impulses + q;
    if (impulses.minCoeff() >= -tiny * impulses.norm() && w.minCoeff() >= -tiny) return impulses;
  }
  return std::nullopt;
}

}  // namespace cs550::test
