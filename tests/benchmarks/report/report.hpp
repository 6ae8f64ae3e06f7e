#pragma once
/// @file report.hpp
/// What `./cs550 bench` measures, before it is printed, written or drawn.

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/quality/quality.hpp"
#include "benchmarks/report/power_law.hpp"

namespace cs550::bench {

/// The cost of one stage by itself.
struct StageCost {
  std::string name;    ///< support/climb/128
  double n = 0;        ///< the size of its problem; 0 if it has only one
  double seconds = 0;  ///< per query, body or constraint
};

/// A run of a scene by one engine.
struct SceneRun {
  std::string engine;
  int effort = 0;      ///< iterations or substeps per step
  double seconds = 0;  ///< per step
  Quality quality;
};

/// All engines in one scene.
struct SceneComparison {
  std::string scene;  ///< S1
  std::string title;
  std::vector<SceneRun> runs;
};

/// The error of each engine over its time, as its effort varies: runs sorted by engine, then effort.
struct Frontier {
  std::string scene;
  std::vector<SceneRun> runs;
};

/// How much faster the steps of a scene are if several threads share their work.
struct ThreadGain {
  std::string scene;
  std::string engine;
  int threads = 0;
  double seconds_alone = 0;   ///< per step with one thread, by the clock
  double seconds_shared = 0;  ///< per step with all of them
  double seconds_copies =
      0;  ///< per step of as many copies of the scene that run at once, a thread each

  double gain() const { return seconds_alone / seconds_shared; }
  /// The gain of threads that share nothing: what the machine allows. Virtual processors may be two halves of a core.
  double largest_gain() const { return threads * seconds_alone / seconds_copies; }
};

/// The cost of a step against the number of bodies.
struct Scaling {
  std::string name;  ///< cubes
  std::vector<Cost> costs;
};

/// What a world keeps on the heap, working storage included.
struct Memory {
  double bytes_per_body = 0;
  double bytes_per_contact = 0;   ///< of a pair of touching cubes
  long allocations_per_step = 0;  ///< in a steady state
};

/// A family of costs, such as support/climb, and its law.
struct FittedFamily {
  std::string name;
  double smallest = 0, largest = 0;  ///< n
  PowerLaw law;
};

struct Report {
  std::string date;       ///< 2026-11-23
  std::string processor;  ///< its model
  int steps = 0;          ///< of each scene
  int rounds = 0;         ///< the smallest time of all rounds is kept
  std::vector<StageCost> stages;
  std::vector<SceneComparison> scenes;
  std::vector<ThreadGain> thread_gains;
  std::vector<Frontier> frontiers;
  std::vector<Scaling> scaling;
  std::optional<Memory> memory;
};

/// The families of stages and scenes that were measured at several sizes.
std::vector<FittedFamily> fitted_families(const Report& report);

/// Today's date, and the processor's model as the system names it.
/// @{
std::string today();
std::string processor_model();
/// @}

/// The report as JSON, for programs and for the figures of the book.
std::string to_json(const Report& report);

}  // namespace cs550::bench
