#pragma once
/// @file stages.hpp
/// The parts of a step, and how each is run: timed, and skipped if it is not written yet.

#include <chrono>

#include "cs550/not_implemented.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Adds its own lifetime to the time of a stage.
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

/// Reports that a lab function is not written yet. Its stage is skipped until the step ends, and
/// without one of the contact stages the step goes on without contacts.
void skip_stage(WorldState& world, Stage stage, const NotImplemented& missing);

/// Runs `part(world, arguments...)` of a stage, unless the stage is known to be unwritten.
template <class Part, class... Arguments>
void run_stage(WorldState& world, Stage stage, const Part& part, const Arguments&... arguments) {
  if (world.unwritten.contains(stage)) return;
  const StageTimer timer(world.stats, stage);
  try {
    part(world, arguments...);
  } catch (const NotImplemented& missing) {
    skip_stage(world, stage, missing);
  }
}

/// One step, stage by stage. @param h s
void advance(WorldState& world, Real h);

/// From bodies to contacts: pairs, axes, manifolds. @param h step (s)
void detect_collisions(WorldState& world, Real h);

/// The parameters of a substep. @param h substep (s)
ContactStep contact_step(const WorldSettings& settings, Real h);
/// Makes the constraints, with masses and first impulses. @pre begin_constraints()
void prepare(WorldState& world, const ContactStep& step);
/// Moves the bodies by one substep and solves their contacts.
void substep(WorldState& world, const ContactStep& step);
/// Whether run_substeps_by_part() does the same as the substeps in turn. @pre prepare()
bool substeps_go_by_part(const WorldState& world);
/// Runs all substeps in as few loops as possible. Call it by run_stage() with Stage::Solve; it subtracts the time
/// that belongs to Stage::Integrate. @pre substeps_go_by_part()
void run_substeps_by_part(WorldState& world, const ContactStep& step, int count);
/// Prepares the constraints and runs all substeps of a step. The grader's judge of lab 7 links another
/// definition, which lets another process run this one: a round trip for each contact would take
/// minutes. What this reads of the world is listed in autograder/grader/substeps_archive.hpp.
void run_substeps(WorldState& world, const ContactStep& step, int count);

/// Checks of what a stage promised. Broken promises are reported in problems(), and their effect is
/// undone. When the step ends, broken bodies return to where they were, without the impulses of their contacts, and the
/// audit leaves out the step.
/// @{
/// @param stage, lab what has just changed the bodies. A body is reported once in a step.
void check_bodies(WorldState& world, Stage stage, int lab);
void restore_broken_bodies(WorldState& world);
void check_axes(WorldState& world);
void check_manifolds(WorldState& world);
/// Compares kept answers with those of fresh queries. @param h step (s)
void check_kept_answers(WorldState& world, Real h);
/// @}

/// The audit of linear momentum: its change during a step, less the impulses from outside the
/// dynamic bodies. Without settings.audit_momentum these do nothing. @param h step, or substep (s)
/// @{
void begin_audit(WorldState& world);
void audit_substep(WorldState& world, Real h);
void end_audit(WorldState& world, Real h);
/// @}

}  // namespace cs550
