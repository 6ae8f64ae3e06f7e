#include "sweeps.hpp"
#include "sweeps_in_lanes.hpp"

namespace cs550::lanes_of_four {

void add_momentum_changes(std::span<RigidBody> bodies, std::span<const SolverBody> solver_bodies) {
  add_changes(bodies, solver_bodies);
}

void turn_dynamic_bodies(std::span<RigidBody> bodies, std::span<SolverBody> solver_bodies, Real h) {
  turn_bodies(bodies, solver_bodies, h);
}

}  // namespace cs550::lanes_of_four
