#pragma once
/// @file stack.hpp
/// The simplest stack: boxes of 1 kg and 1 m on a floor, with one contact between neighbours.

#include "lab6_naive_solver/collision.hpp"

namespace cs550::test {

/// Body 0 is the floor, body k the k-th box from below; constraint k is the contact
/// below box k + 1.
struct Stack {
  explicit Stack(int boxes) : bodies(1), heights(1, Real(-0.5)) {
    const Vec3 up = Vec3(0, 0, Real(0.5));
    for (int k = 1; k <= boxes; ++k) {
      bodies.push_back(movable(1, Vec3::Constant(Real(0.5))));
      heights.push_back(static_cast<Real>(k) - Real(0.5));
      constraints.push_back(touching(Vec3::UnitZ(), up, -up, 0, k - 1, k));
    }
  }

  /// Applies gravity to the velocities for a time h.
  void fall(Real speed) {
    for (std::size_t k = 1; k < bodies.size(); ++k) bodies[k].v.z() -= speed;
  }
  /// Moves the boxes for a time h and measures the gaps between them.
  void move(Real h) {
    for (std::size_t k = 0; k < bodies.size(); ++k) heights[k] += h * bodies[k].v.z();
    for (std::size_t k = 0; k < constraints.size(); ++k)
      constraints[k].separation = heights[k + 1] - heights[k] - 1;
  }
  /// The fastest approach over all contacts (m/s).
  Real approach() const {
    Real fastest = 0;
    for (std::size_t k = 0; k < constraints.size(); ++k)
      fastest = std::max(fastest, bodies[k].v.z() - bodies[k + 1].v.z());
    return fastest;
  }

  std::vector<SolverBody> bodies;
  std::vector<Real> heights;
  std::vector<ContactConstraint> constraints;
};

}  // namespace cs550::test
