#pragma once
/// @file trajectory_csv.hpp
/// Where the bodies were, as a table.

#include <filesystem>
#include <fstream>

#include "cs550/scene.hpp"

namespace cs550::cli {

/// Writes one line per moving body and step: step, time, body, name, position, orientation (w first),
/// velocities. The lines go to a file beside the wanted one, which commit() puts in its place: an
/// interrupted run leaves nothing half-written there.
class TrajectoryCsv {
 public:
  /// Throws std::runtime_error when the folder takes no file.
  explicit TrajectoryCsv(std::filesystem::path file);
  ~TrajectoryCsv();
  TrajectoryCsv(const TrajectoryCsv&) = delete;
  TrajectoryCsv& operator=(const TrajectoryCsv&) = delete;

  /// Adds the bodies as they are now. @param scene gives the bodies their names
  void add(const World& world, const Scene& scene);
  /// Throws std::runtime_error when the disk did not take everything.
  void commit();

 private:
  std::filesystem::path file_;
  std::filesystem::path unfinished_;
  std::ofstream stream_;
};

}  // namespace cs550::cli
