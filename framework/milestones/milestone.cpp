#include "milestone.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cs550/not_implemented.hpp"

namespace cs550::milestones {
namespace {

constexpr double observations_per_second = 10;

/// The first problem of a stage that the milestone needs; empty if there is none.
std::string first_problem(const World& world, int lab) {
  for (const StageProblem& problem : world.problems()) {
    if (problem.lab <= lab) return problem.message;
  }
  return {};
}

void observe(const Milestone& milestone, const World& world, const Scene& scene, Track& track) {
  track.observations.push_back(milestone.observe(world, scene));
  track.times.push_back(world.time());
}

}  // namespace

std::string command_to_watch(const Milestone& milestone) {
  const bool has_a_page_only = milestone.lab >= 3 && milestone.lab <= 5;
  const std::string shown =
      has_a_page_only ? "--lab " + std::to_string(milestone.lab) : milestone.scene;
  return "./cs550 view " + shown + " --student";
}

const std::vector<Milestone>& all_milestones() {
  static const std::vector<Milestone> milestones{
      {1, "free_spin", poses},
      {2, "thrown_shapes", meshes_and_poses},
      {3, "ghosts", lowest_points},
      {4, "ghosts", separations},
      {5, "over_the_edge", contact_patches},
      {6, "collisions", poses},
      {7, "incline", poses},
      {7, "bounce", lowest_points, 2},  // later, rounding decides how a box that lands flat turns
      {7, "standing_wall", heap},
  };
  return milestones;
}

std::vector<Milestone> milestones_of(int lab) {
  std::vector<Milestone> chosen;
  std::copy_if(all_milestones().begin(), all_milestones().end(), std::back_inserter(chosen),
               [lab](const Milestone& milestone) { return milestone.lab == lab; });
  return chosen;
}

Track run(const Milestone& milestone, const Scene& scene, const std::function<void()>& stepped) {
  const int steps_per_observation =
      std::max(1, static_cast<int>(std::lround(1 / (observations_per_second * scene.h))));
  const int steps = milestone.seconds > 0
                        ? static_cast<int>(std::lround(milestone.seconds / scene.h))
                        : scene.steps;
  Track track;
  World world = make_world(scene);
  world.settings().check_stages = true;
  try {
    observe(milestone, world, scene, track);
    for (int step = 1; step <= steps; ++step) {
      world.step(scene.h);
      stepped();
      track.problem = first_problem(world, milestone.lab);
      if (!track.problem.empty()) break;
      if (step % steps_per_observation == 0) observe(milestone, world, scene, track);
    }
  } catch (const NotImplemented& missing) {
    track.problem = missing.what();
  }
  return track;
}

}  // namespace cs550::milestones
