#pragma once
/// @file quality.hpp
/// How well an engine has simulated a scene: one evaluator for all of them, in double precision.

#include <optional>
#include <span>

#include "benchmarks/quality/body_motion.hpp"
#include "benchmarks/scenes/scenes.hpp"

namespace cs550::bench {

/// The errors of a scene that should be at rest.
struct Quality {
  double deepest = 0;         ///< largest penetration_depth() of any pair (m)
  int deep_pairs = 0;         ///< pairs deeper than 2 cm
  double kinetic_energy = 0;  ///< of all bodies (J)
  /// Farthest that any body has moved sideways (m); nothing in a pile, which spreads.
  std::optional<double> drift;
  int lost_bodies = 0;  ///< not finite, or outside the room; the other figures leave them out
};

/// @param motions of all bodies of the scene, in their order
Quality evaluate(const BenchScene& scene, std::span<const BodyMotion> motions);

}  // namespace cs550::bench
