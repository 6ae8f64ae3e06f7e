#pragma once
/// @file systems.hpp
/// Systems of a few bodies and frictionless constraints, prepared by dense algebra.

#include "lab7_constraint_solver/dense_contact.hpp"

namespace cs550::test {

struct System {
  std::vector<SolverBody> bodies;
  std::vector<ContactConstraint> constraints;

  void prepare() {
    for (ContactConstraint& constraint : constraints) {
      prepare_densely(constraint, bodies[constraint.body_a], bodies[constraint.body_b]);
    }
  }
  void pass(int count, const ContactStep& step) {
    for (int i = 0; i < count; ++i) solve_contacts(constraints, bodies, step);
  }
};

/// Three bodies with four contacts in random directions, the last two of one pair.
inline System random_system(Random& random) {
  System system;
  for (int i = 0; i < 3; ++i) system.bodies.push_back(random_body(random));
  const Index pairs[4][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 2}};
  for (const auto& pair : pairs) {
    ContactConstraint constraint = random_constraint(random);
    constraint.body_a = pair[0];
    constraint.body_b = pair[1];
    system.constraints.push_back(constraint);
  }
  system.prepare();
  return system;
}

/// A box of 1 kg at rest that touches the floor with its four lower corners: four constraints of
/// rank three.
inline System box_on_floor(const Vec3& half_extents) {
  System system;
  const Vec3 squares = half_extents.cwiseProduct(half_extents);
  SolverBody box;
  box.inverse_mass = 1;
  box.world_inverse_inertia =
      (3 / (Vec3::Constant(squares.sum()) - squares).array()).matrix().asDiagonal();
  system.bodies = {immovable_body(), box};
  for (const Real x : {Real(-1), Real(1)}) {
    for (const Real y : {Real(-1), Real(1)}) {
      ContactConstraint constraint;
      constraint.body_a = 0;
      constraint.body_b = 1;
      constraint.n = Vec3::UnitZ();
      constraint.u = Vec3::UnitX();
      constraint.r_b = half_extents.cwiseProduct(Vec3(x, y, -1));
      constraint.r_a = constraint.r_b;
      system.constraints.push_back(constraint);
    }
  }
  system.prepare();
  return system;
}

/// The same box with a random motion.
inline System landing_box(Random& random, const Vec3& half_extents) {
  System system = box_on_floor(half_extents);
  system.bodies[1].v = random.point_in_box(Vec3(1, 1, 1)) - Vec3(0, 0, 3);
  system.bodies[1].w = random.point_in_box(Vec3::Constant(2));
  return system;
}

/// Equal cubes of 1 kg in a line along x that touch; the first moves at 1 m/s.
inline System line_of_cubes(int count) {
  System system;
  for (int i = 0; i < count; ++i) {
    SolverBody cube;
    cube.inverse_mass = 1;
    cube.world_inverse_inertia = 6 * Mat3::Identity();
    system.bodies.push_back(cube);
  }
  system.bodies[0].v.x() = 1;
  for (int i = 0; i + 1 < count; ++i) {
    ContactConstraint constraint;
    constraint.body_a = i;
    constraint.body_b = i + 1;
    constraint.n = Vec3::UnitX();
    constraint.u = Vec3::UnitY();
    constraint.r_a = Real(0.5) * constraint.n;
    constraint.r_b = -constraint.r_a;
    system.constraints.push_back(constraint);
  }
  system.prepare();
  return system;
}

}  // namespace cs550::test
