#pragma once
/// @file naive_solver.hpp
/// **Lab 6:** The textbook impulse: one collision at a time. Document §4.1; Baraff, *Rigid Body
/// Simulation II* (1997), §8.

#include <span>

#include "cs550/contact_constraint.hpp"

namespace cs550 {

/// **L6.1** The mass that an impulse along a direction meets at a contact (kg):
/// 1 / (1/m_A + 1/m_B + d·[(I_A⁻¹(r_A × d)) × r_A] + d·[(I_B⁻¹(r_B × d)) × r_B]).
/// 0 for two immovable bodies.
/// @param direction unit, world frame
/// @param r_a, r_b contact from each centre of mass, world frame (m)
Real effective_mass(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                    const Vec3& direction);

/// **L6.2** v_n = n·(v_B + ω_B × r_B − v_A − ω_A × r_A): negative when approaching (m/s).
/// @param n unit, A → B, world frame
Real normal_velocity(const SolverBody& a, const SolverBody& b, const Vec3& r_a, const Vec3& r_b,
                     const Vec3& n);

/// **L6.3** (impulse) and **L6.4** (restitution and the loop) Visits the constraints once, in order: where
/// two bodies touch or overlap (separation ≤ 0) and approach (v_n < 0), applies
/// j = −(1 + e)·v_n·m_e as −j·n to A and +j·n to B, and adds j to the constraint's normal_impulse. Bodies
/// that separate are left alone. Reads geometry and restitution from the constraints, nothing that lab 7
/// prepares.
void resolve_contacts_naive(std::span<ContactConstraint> constraints, std::span<SolverBody> bodies);

}  // namespace cs550
