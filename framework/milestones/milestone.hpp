#pragma once
/// @file milestone.hpp
/// What each lab adds to the assembled engine: a run that is compared with a record of the
/// reference.

#include <functional>
#include <string>
#include <vector>

#include "observation.hpp"

namespace cs550::milestones {

/// A scene, and the quantities that a finished lab makes correct.
struct Milestone {
  int lab = 0;
  std::string scene;  ///< a shipped one; it needs labs 1 to `lab` and no other
  Observation (*observe)(const World& world, const Scene& scene) = nullptr;
  double seconds = 0;  ///< compared from the start; 0: the whole scene

  /// "lab3_ghosts"; its record is framework/assets/trajectories/lab3_ghosts.csv.
  std::string name() const { return "lab" + std::to_string(lab) + '_' + scene; }
};

/// The command that shows a milestone, with the student's code. Bodies of the scenes of labs 3 to 5 do not
/// collide, because the solvers come later. A running scene shows nothing of these labs, but their page does.
std::string command_to_watch(const Milestone& milestone);

/// All milestones, by lab.
const std::vector<Milestone>& all_milestones();

/// The milestones of a lab.
std::vector<Milestone> milestones_of(int lab);

/// A run of a milestone's scene, observed ten times a second.
struct Track {
  std::vector<double> times;              ///< s
  std::vector<Observation> observations;  ///< one for each time
  std::string problem;                    ///< why it ended early; empty if it did not
};

/// Runs a scene with the labs that this program is linked with. A missing or broken stage of labs 1
/// to `lab` ends the run; stages of later labs are ignored.
/// @param stepped called after each step
Track run(
    const Milestone& milestone, const Scene& scene, const std::function<void()>& stepped = [] {});

}  // namespace cs550::milestones
