#pragma once
/// @file run_record.hpp
/// The record of a run of a scene: figures for the summary, and the trajectory as a table.

#include <array>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "cs550/diagnostics.hpp"
#include "cs550/scene.hpp"
#include "files/output_file.hpp"

namespace cs550::cli {

/// Collects figures step by step.
class RunRecord {
 public:
  RunRecord(const Scene& scene, const World& world);

  /// @param seconds duration of the step
  void add_step(const World& world, double seconds);
  /// The next step would lose the finite state. @param broken the stages that do so
  void stop(const std::vector<StageProblem>& broken);

  /// Whether no stage failed, all numbers are finite and the scene's bound on penetration was kept.
  bool good() const;
  /// Prints bodies, contacts, times, energy and errors in at most 80 columns.
  void print(std::ostream& out) const;

 private:
  void print_times(std::ostream& out) const;
  void print_verdict(std::ostream& out) const;
  void add_problems(std::span<const StageProblem> problems);
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
  bool stopped_ = false;
  Real deepest_ = 0;                    ///< penetration, positive (m)
  std::vector<StageProblem> problems_;  ///< each message once
};

/// Writes one line per moving body and step: step, time, body, name, position, orientation (w
/// first), velocities. Functions throw std::runtime_error if the file cannot be written.
class TrajectoryCsv {
 public:
  explicit TrajectoryCsv(const std::filesystem::path& file);

  /// Adds the bodies as they are now. @param scene gives the bodies their names
  void add(const World& world, const Scene& scene);
  /// The file appears.
  void commit() { file_.commit(); }

 private:
  files::OutputFile file_;
};

}  // namespace cs550::cli
