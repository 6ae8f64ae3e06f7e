#include "benchmarks/runs/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

namespace cs550::bench {
namespace {

/// A run that is repeated in every round.
struct Contender {
  const Engine* engine;
  int effort;
};

/// Time of the processor in this thread (s): other programs do not count.
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_per_step(Simulation& simulation, int steps) {
  const double start = thread_seconds();
  for (int i = 0; i < steps; ++i) simulation.step(step_length);
  return (thread_seconds() - start) / steps;
}

Quality quality_of(const BenchScene& scene, const Simulation& simulation) {
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.push_back(simulation.motion(i));
  return evaluate(scene, motions);
}

/// The contenders take turns, so that a change of the machine's speed affects all of them. Their
/// results do not change from round to round.
std::vector<SceneRun> run_in_turn(const NamedScene& named, std::span<const Contender> contenders,
                                  const Duration& duration, const Announce& announce) {
  const BenchScene scene = named.make();
  std::vector<SceneRun> runs;
  for (int round = 0; round < duration.rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const auto& [engine, effort] = contenders[i];
      announce(fmt::format("{}, {}, {} {}", named.name, engine->name, effort, engine->effort_name));
      if (round == 0) {
        runs.push_back(run_scene(scene, *engine, effort, duration.steps));
        continue;
      }
      const double seconds = seconds_per_step(*engine->start(scene, effort), duration.steps);
      runs[i].seconds = std::min(runs[i].seconds, seconds);
    }
  }
  return runs;
}

}  // namespace

SceneRun run_scene(const BenchScene& scene, const Engine& engine, int effort, int steps) {
  const std::unique_ptr<Simulation> simulation = engine.start(scene, effort);
  const double seconds = seconds_per_step(*simulation, steps);
  return {engine.name, effort, seconds, quality_of(scene, *simulation)};
}

SceneComparison compare(const NamedScene& scene, std::span<const Engine> engines,
                        const Duration& duration, const Announce& announce) {
  std::vector<Contender> contenders;
  for (const Engine& engine : engines) contenders.push_back({&engine, engine.usual_effort});
  return {scene.name, scene.title, run_in_turn(scene, contenders, duration, announce)};
}

Frontier trace_frontier(const NamedScene& scene, std::span<const Engine> engines,
                        const Duration& duration, const Announce& announce) {
  std::vector<Contender> contenders;
  for (const Engine& engine : engines) {
    for (const int effort : engine.efforts) contenders.push_back({&engine, effort});
  }
  return {scene.name, run_in_turn(scene, contenders, duration, announce)};
}

std::vector<ScaledScene> scaled_scenes() {
  return {{"cubes", {4, 7, 10, 14, 20, 28}, columns_of_cubes},
          {"hulls", {4, 8, 12, 16, 22}, [](int across) { return pile_of_hulls(across, 8, 32); }},
          {"hulls_of_64_shapes", {4, 8, 12, 16, 22}, [](int across) {
             return pile_of_shared_hulls(across, 8, 32, 64);
           }}};
}

std::vector<SizedScene> make_scenes(const ScaledScene& family) {
  std::vector<SizedScene> scenes;
  for (const int across : family.across) {
    SizedScene& sized = scenes.emplace_back(SizedScene{family.make(across)});
    const std::vector<BodyDef>& bodies = sized.scene.bodies;
    sized.bodies =
        static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [](const BodyDef& body) {
          return body.kind == BodyKind::Dynamic;
        }));
  }
  return scenes;
}

Duration duration_of_scaling(Duration duration) {
  constexpr int most_steps = 120;
  duration.steps = std::min(duration.steps, most_steps);
  return duration;
}

Scaling measure_scaling(const ScaledScene& family, const Duration& duration,
                        const Announce& announce) {
  const int steps = duration_of_scaling(duration).steps;
  const Engine engine = own_engines().front();
  const std::vector<SizedScene> scenes = make_scenes(family);
  Scaling scaling{family.name, {}};
  for (const SizedScene& sized : scenes) {
    scaling.costs.push_back({static_cast<double>(sized.bodies), HUGE_VAL});
  }
  for (int round = 0; round < duration.rounds; ++round) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      Cost& cost = scaling.costs[i];
      announce(fmt::format("{} {}", cost.n, family.name));
      const std::unique_ptr<Simulation> simulation =
          engine.start(scenes[i].scene, engine.usual_effort);
      cost.seconds = std::min(cost.seconds, seconds_per_step(*simulation, steps));
    }
  }
  return scaling;
}

}  // namespace cs550::bench
