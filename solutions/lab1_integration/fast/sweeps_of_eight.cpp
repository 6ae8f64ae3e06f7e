#include "sweeps_in_lanes.hpp"

#if CS550_HAS_AVX2_FORMS

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

// After all others:
#include "engine/begin_avx2.hpp"
//
#include "sweeps.hpp"

namespace cs550::lanes_of_eight {

void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies) {
  add_changes(bodies, solver_bodies);
}

void turn_dynamic_bodies(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h) {
  turn_bodies(bodies, solver_bodies, h);
}

}  // namespace cs550::lanes_of_eight

#include "engine/end_avx2.hpp"

#endif
