#pragma once
/// @file systems.hpp
/// A few bodies and frictionless rows, prepared by dense algebra.

#include "lab7_constraint_solver/dense_contact.hpp"

namespace cs550::test {

struct System {
  std::vector<BodyVelocity> bodies;
  std::vector<ContactRow> rows;

  void prepare() {
    for (ContactRow& row : rows) {
      prepare_densely(row, bodies[static_cast<std::size_t>(row.body_a)],
                      bodies[static_cast<std::size_t>(row.body_b)]);
    }
  }
  void pass(int count, const ContactStep& step) {
    for (int i = 0; i < count; ++i) solve_contacts(rows, bodies, step);
  }
};

/// Three bodies with four contacts in random directions, the last two of one pair.
inline System random_system(Random& random) {
  System system;
  for (int i = 0; i < 3; ++i) system.bodies.push_back(random_body(random));
  const Index pairs[4][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 2}};
  for (const auto& pair : pairs) {
    ContactRow row = random_row(random);
    row.body_a = pair[0];
    row.body_b = pair[1];
    system.rows.push_back(row);
  }
  system.prepare();
  return system;
}

/// A box of 1 kg at rest that touches the floor with its four lower corners: four rows of rank three.
inline System box_on_floor(const Vec3& half_extents) {
  System system;
  const Vec3 squares = half_extents.cwiseProduct(half_extents);
  BodyVelocity box;
  box.inverse_mass = 1;
  box.world_inverse_inertia =
      (3 / (Vec3::Constant(squares.sum()) - squares).array()).matrix().asDiagonal();
  system.bodies = {immovable_body(), box};
  for (const Real x : {Real(-1), Real(1)}) {
    for (const Real y : {Real(-1), Real(1)}) {
      ContactRow row;
      row.body_a = 0;
      row.body_b = 1;
      row.n = Vec3::UnitZ();
      row.u = Vec3::UnitX();
      row.r_b = half_extents.cwiseProduct(Vec3(x, y, -1));
      row.r_a = row.r_b;
      system.rows.push_back(row);
    }
  }
  system.prepare();
  return system;
}

/// The same, falling and turning at random.
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
    BodyVelocity cube;
    cube.inverse_mass = 1;
    cube.world_inverse_inertia = 6 * Mat3::Identity();
    system.bodies.push_back(cube);
  }
  system.bodies[0].v.x() = 1;
  for (int i = 0; i + 1 < count; ++i) {
    ContactRow row;
    row.body_a = i;
    row.body_b = i + 1;
    row.n = Vec3::UnitX();
    row.u = Vec3::UnitY();
    row.r_a = Real(0.5) * row.n;
    row.r_b = -row.r_a;
    system.rows.push_back(row);
  }
  system.prepare();
  return system;
}

}  // namespace cs550::test
