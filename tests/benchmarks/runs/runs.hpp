#pragma once
/// @file runs.hpp
/// Whole scenes: how long a step takes, and how good its result is.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/engines/engine.hpp"
#include "benchmarks/report/report.hpp"

namespace cs550::bench {

/// Every step is 1/60 s long.
inline constexpr Real step_length = Real(1) / 60;

/// How long to measure.
struct Duration {
  int steps = 600;  ///< of each scene
  int rounds = 1;   ///< the engines run in turn, and the smallest time of each counts
};

/// Called with what is about to run.
using Announce = std::function<void(const std::string& what)>;

/// Runs a scene from its start. The time is that of the processor, per step.
SceneRun run_scene(const BenchScene& scene, const Engine& engine, int effort, int steps);

/// Each engine with its usual effort.
SceneComparison compare(const NamedScene& scene, std::span<const Engine> engines,
                        const Duration& duration, const Announce& announce);

/// Each engine with each of its efforts.
Frontier trace_frontier(const NamedScene& scene, std::span<const Engine> engines,
                        const Duration& duration, const Announce& announce);

/// A family of scenes of growing size.
struct ScaledScene {
  const char* name;         ///< cubes
  std::vector<int> across;  ///< sizes
  BenchScene (*make)(int across);
};

/// Up to 8,000 cubes in columns and 4,000 hulls in a pile.
std::vector<ScaledScene> scaled_scenes();

/// A scene of a family, and the number of bodies in it that move.
struct SizedScene {
  BenchScene scene;
  int bodies = 0;
};

/// The scenes of a family, the smallest first.
std::vector<SizedScene> make_scenes(const ScaledScene& family);

/// How long to measure a scene of a family: its first two seconds, or less if `duration` is shorter.
Duration duration_of_scaling(Duration duration);

/// The cost of a step of this engine.
Scaling measure_scaling(const ScaledScene& family, const Duration& duration,
                        const Announce& announce);

/// This engine with each of its settings, by one thread and by several: medians of the rounds.
/// @param name of the scene
std::vector<ThreadGain> compare_threads(const std::string& name, const BenchScene& scene,
                                        int threads, const Duration& duration,
                                        const Announce& announce);

/// Heap memory of this engine's world, and allocations in a steady state.
Memory measure_memory();

}  // namespace cs550::bench
