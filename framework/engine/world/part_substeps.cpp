/// @file part_substeps.cpp
/// The substeps of a step in which several threads solve the parts of the world.
///
/// After each loop that threads share, all wait for the slowest. Most of what a substep does concerns one
/// part alone, so a thread continues with its part until contacts between parts have to be solved. Where
/// there are none, it runs all substeps of its part in one loop.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "engine/body_sweeps.hpp"
#include "engine/contacts/contact_constraints.hpp"
#include "engine/contacts/solver_bodies.hpp"
#include "engine/world/stages.hpp"
#include "engine/world/substep_passes.hpp"

namespace cs550 {

namespace {

/// Whether a phase of the solve order has any contacts.
bool has_contacts(const SolveOrder& order, std::size_t phase) {
  const std::span units =
      std::span(order.units)
          .subspan(order.phases[phase], order.phases[phase + 1] - order.phases[phase]);
  return std::any_of(units.begin(), units.end(),
                     [](const SolveUnit& unit) { return unit.first_contact != unit.end_contact; });
}

/// Builds the list of the tasks of a substep.
class TaskList {
 public:
  explicit TaskList(WorldState& world) : order_(world.solve_order), tasks_(world.tasks) {
    tasks_.clear();
  }

  void for_parts(PartWork work) { tasks_.push_back({work, 0, {}}); }

  /// Work that precedes the next work of each unit. It may change nothing that other units read.
  void before_next(PartWork work) { pending_.fill(work); }

  void for_units(PartWork work, const Passes& passes = {}) {
    for (std::size_t i = 0; i < phase_count; ++i) {
      const std::size_t phase = passes.backwards ? phase_count - 1 - i : i;
      if (phase > 0 && !has_contacts(order_, phase)) continue;
      if (pending_[phase]) tasks_.push_back({*std::exchange(pending_[phase], {}), phase, {}});
      tasks_.push_back({work, phase, passes});
    }
  }

  void for_passes(PartWork work, const Passes& passes) {
    for (int i = 0; i < passes.count; ++i) for_units(work, passes.one(i));
    if (passes.count == 0 && passes.mark_impacts) for_units(work, passes);
  }

 private:
  const SolveOrder& order_;
  std::vector<PartTask>& tasks_;
  std::array<std::optional<PartWork>, phase_count> pending_;
};

/// The order is that of substep(). Only masses are refreshed later, without loops of their own: they do not depend on
/// velocities. Bounces, checks and recovery from overlap are missing: a step that needs them does not go by part.
void list_tasks(WorldState& world, const ContactStep& step) {
  TaskList tasks(world);
  tasks.for_parts(PartWork::ApplyForces);
  tasks.before_next(PartWork::RefreshMasses);
  tasks.for_units(PartWork::BiasedPasses, {.warm_start = true, .store = false});
  if (resists_rolling(world.settings)) tasks.for_units(PartWork::ResistRolling);
  tasks.for_passes(PartWork::BiasedPasses, biased_passes(world, step));
  tasks.for_parts(PartWork::Move);
  tasks.before_next(PartWork::RefreshThinMasses);
  tasks.for_passes(PartWork::RelaxPasses, relax_passes(world));
  tasks.for_parts(PartWork::KeepMomenta);
}

/// What the threads do to a part, or to a unit of contacts between parts.
class PartSubsteps {
 public:
  PartSubsteps(WorldState& world, const ContactStep& step)
      : world_(world), biased_(step), relaxing_(step) {
    relaxing_.use_bias = false;
  }

  void run(const PartTask& task, std::size_t unit) {
    // Integration is timed on the thread of the first part alone: several threads must not add to one sum.
    std::optional<StageTimer> timer;
    const bool integrates = task.work == PartWork::ApplyForces || task.work == PartWork::Move;
    if (unit == 0 && integrates) timer.emplace(world_.stats, Stage::Integrate);
    switch (task.work) {
      case PartWork::ApplyForces:
        return for_bodies_of(unit, [&](std::size_t first, std::size_t last) {
          integrate_momenta(bodies(first, last), biased_.h);
          gather_dynamic(first, last);
        });
      case PartWork::RefreshMasses:
        return refresh_masses(world_, biased_, unit);
      case PartWork::BiasedPasses:
        return run_passes(unit, biased_, task.passes);
      case PartWork::ResistRolling:
        return resist_rolling(world_, unit);
      case PartWork::Move:
        return for_bodies_of(unit, [&](std::size_t first, std::size_t last) {
          add_momentum_changes(bodies(first, last), solver_bodies(first, last));
          integrate_poses(bodies(first, last), solver_bodies(first, last), biased_.h,
                          world_.settings.rotation);
          gather_dynamic(first, last);
          measure_turns(world_, first, last, biased_.h);
        });
      case PartWork::RefreshThinMasses:
        return refresh_masses_of_thin_bodies(world_, biased_, unit);
      case PartWork::RelaxPasses:
        return run_passes(unit, relaxing_, task.passes);
      case PartWork::KeepMomenta:
        return for_bodies_of(unit, [&](std::size_t first, std::size_t last) {
          add_momentum_changes(bodies(first, last), solver_bodies(first, last));
        });
    }
  }

 private:
  template <class Work>
  void for_bodies_of(std::size_t part, const Work& work) {
    for_few_bodies(static_cast<std::size_t>(world_.parts.first[part]),
                   static_cast<std::size_t>(world_.parts.first[part + 1]), work);
  }
  std::span<RigidBody> bodies(std::size_t first, std::size_t last) {
    return std::span(world_.bodies).subspan(first, last - first);
  }
  std::span<SolverBody> solver_bodies(std::size_t first, std::size_t last) {
    return std::span(world_.solver_bodies).subspan(first, last - first);
  }

  /// Other threads read the immovable bodies, which stay as they are.
  void gather_dynamic(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (world_.bodies[i].kind == BodyKind::Dynamic) {
        gather(world_.bodies[i], world_.solver_bodies[i]);
      }
    }
  }

  void run_passes(std::size_t unit, const ContactStep& step, const Passes& passes) {
    cs550::run_passes(world_.mirrors.of_units[unit],
                      constraints_of(world_, world_.solve_order.units[unit]), world_.solver_bodies,
                      step, passes);
  }

  WorldState& world_;
  ContactStep biased_;
  ContactStep relaxing_;
};

}  // namespace

/// A kinematic body moves and may touch bodies of several parts, whose threads would read it meanwhile.
bool substeps_go_by_part(const WorldState& world) {
  return world.parts.renumbered && !world.parts.any_kinematic && !world.unwritten.any() &&
         is_soft(world.settings) && world.settings.warm_starting;
}

void run_substeps_by_part(WorldState& world, const ContactStep& step, int count) {
  const auto seconds = [&](Stage stage) -> double& {
    return world.stats.seconds[static_cast<std::size_t>(stage)];
  };
  const double integrated_before = seconds(Stage::Integrate);
  world.impacts.any = false;
  list_tasks(world, step);
  PartSubsteps substeps(world, step);
  const std::vector<PartTask>& tasks = world.tasks;
  const auto phase_of = [&](std::size_t i) { return tasks[i % tasks.size()].phase; };
  const std::size_t end = tasks.size() * static_cast<std::size_t>(count);
  for (std::size_t first = 0, last = 0; first < end; first = last) {
    // Tasks of one phase that follow each other are a single loop.
    while (last < end && phase_of(last) == phase_of(first)) ++last;
    for_units_of_phase(world.team, world.solve_order, phase_of(first), [&](std::size_t unit) {
      for (std::size_t i = first; i < last; ++i) substeps.run(tasks[i % tasks.size()], unit);
    });
  }
  // run_stage() adds the time of this whole function to Stage::Solve.
  seconds(Stage::Solve) -= seconds(Stage::Integrate) - integrated_before;
}

}  // namespace cs550
