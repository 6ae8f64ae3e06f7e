#pragma once
/// @file engine.hpp
/// What a comparison needs of an engine.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/quality/body_motion.hpp"
#include "benchmarks/scenes/scenes.hpp"

namespace cs550::bench {

/// A scene that runs in one engine, without sleeping.
class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Advances the scene by one step. @param h s
  virtual void step(Real h) = 0;
  /// @param body index in BenchScene::bodies
  virtual BodyMotion motion(std::size_t body) const = 0;
};

/// An engine with its settings.
struct Engine {
  std::string name;          ///< "Bullet"
  std::string effort_name;   ///< "iterations" or "substeps" per step
  int usual_effort = 0;      ///< its default
  std::vector<int> efforts;  ///< for the frontier of error over time
  /// @param effort number of iterations or substeps
  std::function<std::unique_ptr<Simulation>(const BenchScene& scene, int effort)> start;
};

/// This engine, first with its default settings. @param threads that share the work of every step
std::vector<Engine> own_engines(int threads = 1);
/// The engines of the package group `peers` that were there when this program was built, on one thread.
std::vector<Engine> peer_engines();

}  // namespace cs550::bench
