#pragma once
/// @file body_sweeps.hpp
/// What a substep does to every body, in one sweep over the array each. The definitions here call the
/// functions of lab 1. `solutions/lab1_integration/fast/` replaces them with faster forms that leave
/// the same bits.
///
/// Precondition of all three: velocities and world_inverse_inertia are those that refresh_velocity()
/// derives from the state. They leave them so. Sleeping bodies are skipped.

#include <span>

#include "cs550/integration.hpp"
#include "cs550/solver_body.hpp"

namespace cs550 {

/// integrate_momentum() and refresh_velocity() for every dynamic body. @param h substep (s)
void integrate_momenta(std::span<RigidBody> bodies, Real h);

/// Gives every dynamic body the momenta that belong to the velocities in the solver bodies. Only the
/// *change* is added, so that a body without contacts keeps P and L to the last bit.
void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies);

/// turn_and_move() for every body that moves. What it moves is added to the displacements of its
/// solver body. @param h substep (s)
void integrate_poses(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h,
                     RotationMethod method);

/// The kinetic energy of a body's rotation (J). @pre velocities are up to date
Real turning_energy(const RigidBody& body);
/// integrate_pose() and refresh_velocity() for one body, with a guard against turns that the midpoint
/// iteration cannot follow. @param h substep (s)
void turn_and_move(RigidBody& body, Real h, RotationMethod method);

/// The part of its energy by which the guard lets a turn change it.
inline constexpr Real allowed_change = Real(1e-4);

}  // namespace cs550
