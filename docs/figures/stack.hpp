#pragma once
/// @file stack.hpp
/// The tower that solvers are tried on: boxes of 1 m on a floor, without gaps.

#include "cs550/world.hpp"

namespace cs550::book {

/// A static floor whose upper side is the plane z = 0.
void add_floor(World& world, Real friction = Real(0.6));
/// A box in a world. @return its name
BodyId add_box(World& world, const Vec3& half_extents, const Pose& pose, Real friction = Real(0.6),
               Real restitution = 0);
/// @param iterations passes with bias in a substep
World stack_of_boxes(int count, SolverKind solver, int iterations = WorldSettings{}.iterations);

}  // namespace cs550::book
