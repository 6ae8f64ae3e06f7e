#pragma once
/// @file selection.hpp
/// Which benchmarks to run, by their names.

#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/runs/runs.hpp"
#include "benchmarks/stages/stage.hpp"

namespace cs550::bench {

/// A command line that asks for something that is not there.
struct Misuse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The benchmarks of a run. Their names: support/climb/128, scene/S1, frontier/S1, step/cubes, memory.
struct Selection {
  std::vector<Stage> stages;
  std::vector<NamedScene> scenes;
  std::vector<NamedScene> frontiers;
  std::vector<ScaledScene> scaling;
  bool memory = false;

  std::vector<std::string> names() const;
};

/// All benchmarks whose name contains a match of a regular expression (ECMAScript).
/// @param with_frontiers frontiers take minutes
/// @throws Misuse if the expression is malformed or matches nothing
Selection select(const std::string& filter, bool with_frontiers);

}  // namespace cs550::bench
