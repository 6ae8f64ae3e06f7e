#pragma once
/// @file naive_solver.hpp
/// **Lab 6:** The naive solver: resolves one collision at a time with the textbook impulse.
/// Document §4.1; Baraff, *Rigid Body Simulation II* (1997), §8.

#include <span>

#include "cs550/contact_constraint.hpp"

namespace cs550 {

/// **L6.1** The effective mass of a contact along a direction (kg): the impulse that changes the
/// relative velocity of the two contact points along the direction by 1 m/s, rotation included.
/// Returns 0 for two immovable bodies, so that every impulse between them is 0.
/// @param direction unit, world frame
/// @param r_a, r_b contact from each centre of mass, world frame (m)
Real effective_mass(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                    const Vec3& direction);

/// **L6.2** The normal velocity v_n (m/s): the velocity of B's contact point relative to A's along
/// n, rotation included. Negative when approaching.
/// @param r_a, r_b contact from each centre of mass, world frame (m)
/// @param n unit, A → B, world frame
Real normal_velocity(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                     const Vec3& n);

/// **L6.3** (impulse) and **L6.4** (restitution and the loop) Visits the constraints once, in
/// order. If two bodies touch or overlap (separation ≤ 0) and approach (v_n < 0), they receive
/// equal and opposite impulses along n, after which they separate at e times their speed of
/// approach; the magnitude is added to the constraint's normal_impulse. All other constraints stay
/// unchanged. Uses the geometry and the restitution of a constraint, but no field that lab 7
/// computes.
void resolve_contacts_naive(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies);

}  // namespace cs550
