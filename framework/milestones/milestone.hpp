#pragma once
/// @file milestone.hpp
/// What each lab adds to the assembled engine, as a run that can be compared with a record of the
/// reference.

#include <string>
#include <vector>

#include "observation.hpp"

namespace cs550::milestones {

/// One scene, and what of it a finished lab makes right.
struct Milestone {
  int lab = 0;
  std::string scene;  ///< a shipped one; it needs labs 1 to `lab` and no other
  Observation (*observe)(const World& world, const Scene& scene) = nullptr;
  double seconds = 0;  ///< how long it can be compared; 0: as long as the scene runs

  /// "lab3_ghosts": of its record, framework/assets/trajectories/lab3_ghosts.csv.
  std::string name() const { return "lab" + std::to_string(lab) + '_' + scene; }
};

/// All of them, by lab.
const std::vector<Milestone>& all_milestones();

/// Those of a lab.
std::vector<Milestone> milestones_of(int lab);

/// A run of a milestone's scene, looked at ten times a second.
struct Track {
  std::vector<double> times;              ///< s
  std::vector<Observation> observations;  ///< one for each time
  std::string problem;                    ///< why it ends early, in words; else empty
};

/// Runs a scene with the labs that this program is linked with. What labs after the milestone's
/// have to say is of no interest here: only a stage of labs 1 to `lab` that is missing or broken
/// ends the run.
Track run(const Milestone& milestone, const Scene& scene);

}  // namespace cs550::milestones
