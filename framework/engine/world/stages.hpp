#pragma once
/// @file stages.hpp
/// How the stages of a step are run, and what each of them does to the world.

#include <algorithm>
#include <chrono>

#include "cs550/not_implemented.hpp"
#include "engine/world/world_state.hpp"

namespace cs550 {

/// Adds the time until its end of life to a stage's account.
class StageTimer {
 public:
  StageTimer(StepStats& stats, Stage stage)
      : seconds_(stats.seconds[static_cast<std::size_t>(stage)]), start_(Clock::now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_;
};

/// Runs a stage; one that is not written yet is reported once per step, and the step goes on.
template <class Run>
bool attempt(WorldState& world, Stage stage, Run run) {
  const StageTimer timer(world.stats, stage);
  try {
    run();
    return true;
  } catch (const NotImplemented& missing) {
    const auto same = [&](const StageProblem& known) { return known.message == missing.what(); };
    if (std::none_of(world.problems.begin(), world.problems.end(), same)) {
      world.problems.push_back({stage, missing.lab(), no_index, world.step_count, missing.what()});
    }
    return false;
  }
}

template <class Visit>
void for_dynamic_bodies(WorldState& world, Visit visit) {
  for (RigidBody& body : world.bodies) {
    if (body.kind == BodyKind::Dynamic) visit(body);
  }
}

template <class Visit>
void for_moving_bodies(WorldState& world, Visit visit) {
  for (RigidBody& body : world.bodies) {
    if (body.kind != BodyKind::Static) visit(body);
  }
}

/// From bodies to contacts: pairs, axes, manifolds. Without manifolds where a stage is not written.
/// @param h step (s)
void detect_collisions(WorldState& world, Real h);
/// Leaves the pairs, but no point in which they touch.
void drop_manifolds(WorldState& world);

/// What the solver is told of the world's settings. @param h substep (s)
ContactStep contact_step(const WorldSettings& settings, Real h);
/// From contacts to constraints and velocities, which the substeps share.
void prepare(WorldState& world, const ContactStep& step);
/// One substep. @param with_contacts whether there are constraints to solve; false once a solver's stage
/// turns out not to be written
void substep(WorldState& world, const ContactStep& step, bool& with_contacts);

}  // namespace cs550
