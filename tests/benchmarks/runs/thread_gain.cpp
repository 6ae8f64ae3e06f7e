/// What several threads gain. On a machine that others share, a core may be a quarter faster for a second, or the cores far
/// apart. One thread, several threads and copies therefore take turns, a few steps each, and each turn counts with its median.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <thread>

#include "benchmarks/runs/runs.hpp"

namespace cs550::bench {
namespace {

constexpr int steps_in_turn = 20;

/// Copies of a scene that run at once, a thread each.
class Copies {
 public:
  Copies(const BenchScene& scene, const Engine& engine, int count) {
    for (int i = 0; i < count; ++i)
      simulations_.push_back(engine.start(scene, engine.usual_effort));
  }

  void advance(int steps) const {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < simulations_.size(); ++i) {
      others.emplace_back([this, i, steps] { advance(*simulations_[i], steps); });
    }
    advance(*simulations_.front(), steps);
  }

 private:
  static void advance(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) simulation.step(step_length);
  }

  std::vector<std::unique_ptr<Simulation>> simulations_;
};

/// By the clock, until the last copy has ended (s).
double time_of(const Copies& copies, int steps) {
  const auto start = std::chrono::steady_clock::now();
  copies.advance(steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The time of each turn, in every round (s).
class TurnTimes {
 public:
  explicit TurnTimes(int turns) : of_turns_(static_cast<std::size_t>(turns)) {}

  void note(int turn, double seconds) {
    of_turns_[static_cast<std::size_t>(turn)].push_back(seconds);
  }

  double sum_of_medians() {
    double sum = 0;
    for (std::vector<double>& rounds : of_turns_) {
      const auto middle = rounds.begin() + static_cast<std::ptrdiff_t>((rounds.size() - 1) / 2);
      std::nth_element(rounds.begin(), middle, rounds.end());
      sum += *middle;
    }
    return sum;
  }

 private:
  std::vector<std::vector<double>> of_turns_;
};

}  // namespace

std::vector<ThreadGain> compare_threads(const std::string& name, const BenchScene& scene,
                                        int threads, const Duration& duration,
                                        const Announce& announce) {
  const std::vector<Engine> alone = own_engines();
  const std::vector<Engine> shared = own_engines(threads);
  const int turns = (duration.steps + steps_in_turn - 1) / steps_in_turn;
  std::vector<ThreadGain> gains;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    std::array<TurnTimes, 3> times = {TurnTimes(turns), TurnTimes(turns), TurnTimes(turns)};
    for (int round = 0; round < duration.rounds; ++round) {
      announce(fmt::format("{}, {}, one thread and {}", name, alone[i].name, threads));
      const std::array<Copies, 3> contenders = {Copies(scene, alone[i], 1),
                                                Copies(scene, shared[i], 1),
                                                Copies(scene, alone[i], threads)};
      for (int turn = 0; turn < turns; ++turn) {
        const int steps = std::min(steps_in_turn, duration.steps - turn * steps_in_turn);
        for (std::size_t way = 0; way < times.size(); ++way) {
          times[way].note(turn, time_of(contenders[way], steps));
        }
      }
    }
    const auto per_step = [&](TurnTimes& of_turns) {
      return of_turns.sum_of_medians() / duration.steps;
    };
    gains.push_back(
        {name, alone[i].name, threads, per_step(times[0]), per_step(times[1]), per_step(times[2])});
  }
  return gains;
}

}  // namespace cs550::bench
