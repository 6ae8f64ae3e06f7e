#pragma once
/// @file sweeps_in_lanes.hpp
/// The sweeps over dynamic bodies in two forms that give the same bits.

#include "engine/body_sweeps.hpp"
#include "engine/instruction_set.hpp"

namespace cs550 {

namespace lanes_of_four {
/// add_momentum_changes().
void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies);
/// integrate_poses() by the implicit midpoint, for dynamic bodies only. @param h substep (s)
void turn_dynamic_bodies(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h);
}  // namespace lanes_of_four

#if CS550_HAS_AVX2_FORMS
/// @pre has_avx2()
namespace lanes_of_eight {
void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies);
void turn_dynamic_bodies(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h);
}  // namespace lanes_of_eight
#endif

}  // namespace cs550
