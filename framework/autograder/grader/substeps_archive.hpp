#pragma once
/// @file substeps_archive.hpp
/// The part of a world that run_substeps() works on, as bytes, and what it changes.

#include <cereal/types/string.hpp>

#include "engine/world_state.hpp"
#include "serialisation/named_content.hpp"

namespace cs550 {

template <class Archive>
void serialize(Archive& archive, StageProblem& problem) {
  auto& [stage, lab, body, step, message] = problem;
  archive(stage, lab, body, step, message);
}

template <class Archive>
void serialize(Archive& archive, BodySize& size) {
  archive(size.squared_slenderness, size.squared_length);
}

/// Without the working storage of its schedule.
template <class Archive>
void serialize(Archive& archive, SolveUnit& unit) {
  archive(unit.first_place, unit.end_place, unit.groups);
}

namespace grader {

template <class Archive, class World>
void archive_substeps_input(Archive& archive, World& world) {
  archive(world.settings, world.bodies, world.sizes, world.solver_bodies, world.constraints,
          world.any_bounces, world.pairs.contacts, world.pairs.impulse_energy,
          world.solve_order.place_of_point, world.solve_order.first_point,
          world.solve_order.contacts, world.solve_order.units, world.solve_order.phases,
          world.recovery.any, world.recovery.recovers, world.step_count);
}

/// Of the bodies only the state: all else that a substep changes derives from it. Static bodies
/// stay where they are.
template <class Archive, class World>
void archive_substeps_output(Archive& archive, World& world) {
  for (auto& body : world.bodies) {
    if (body.kind == BodyKind::Static) continue;
    archive(body.pose, body.linear_momentum, body.angular_momentum);
  }
  archive(world.constraints, world.problems);
}

}  // namespace grader
}  // namespace cs550
