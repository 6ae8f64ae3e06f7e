#pragma once
/// @file stage.hpp
/// Stages of a step, each measured alone by Google Benchmark.

#include <benchmark/benchmark.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/report/report.hpp"

namespace cs550::bench {

/// One benchmark.
struct Stage {
  std::string name;  ///< family and size: support/climb/128
  double n = 0;      ///< the size, for the exponent; 0 if it has only one
  double items = 1;  ///< queries, bodies or constraints in one iteration
  std::function<void(benchmark::State&)> run;
};

/// The stages of each part of a step.
/// @{
std::vector<Stage> support_stages();
std::vector<Stage> gauss_map_stages();
std::vector<Stage> axis_stages();
std::vector<Stage> gjk_stages();
std::vector<Stage> manifold_stages();
std::vector<Stage> pass_stages();
std::vector<Stage> broad_phase_stages();
std::vector<Stage> integration_stages();
/// @}
/// All of them.
std::vector<Stage> all_stages();

/// 8, 16, 32, …
/// @param first, last powers of two
std::vector<int> doubled(int first, int last);

/// The name of a member of a family.
std::string member(const std::string& family, int n);

/// Measures stages one after the other.
/// @param seconds of each measurement
/// @param finished called with the number of stages measured so far
std::vector<StageCost> measure_stages(std::span<const Stage> stages, double seconds,
                                      const std::function<void(int)>& finished);

}  // namespace cs550::bench
