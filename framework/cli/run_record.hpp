#pragma once
/// @file run_record.hpp
/// What happened in a run of a scene, and how it is told.

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"

namespace cs550::cli {

/// Gathers figures from step to step.
class RunRecord {
 public:
  RunRecord(const Scene& scene, const World& world);

  /// @param seconds that the step took
  void add_step(const World& world, double seconds);

  /// Whether every stage worked, all numbers are finite and the scene's bound on penetration held.
  bool good() const;
  /// Bodies, contacts, times, energy, errors: at most 80 columns.
  void print(std::ostream& out) const;

 private:
  void print_times(std::ostream& out) const;
  void print_verdict(std::ostream& out) const;
  bool too_deep() const;
  Real substep() const;

  const Scene& scene_;
  const World& world_;
  Energy energy_at_start_;
  int steps_ = 0;
  double seconds_ = 0;
  std::array<double, stage_count> stage_seconds_{};
  int most_contacts_ = 0;
  int most_points_ = 0;
  Real deepest_ = 0;                    ///< penetration, positive (m)
  std::vector<StageProblem> problems_;  ///< each message once
};

}  // namespace cs550::cli
