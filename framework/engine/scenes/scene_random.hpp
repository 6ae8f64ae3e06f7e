#pragma once
/// @file scene_random.hpp
/// Random numbers of scenes: the same with every compiler and library.

#include <cstdint>
#include <random>

#include "cs550/math.hpp"

namespace cs550 {

/// std::mt19937 is specified bit for bit, the distributions of the standard library are not.
class SceneRandom {
 public:
  explicit SceneRandom(std::uint32_t seed) : bits_(seed) {}

  std::uint32_t bits() { return static_cast<std::uint32_t>(bits_()); }

  /// Uniform in [lower, upper].
  Real real(Real lower, Real upper) {
    const double unit = static_cast<double>(bits_()) / 4294967296.0;
    return static_cast<Real>(lower + (static_cast<double>(upper) - lower) * unit);
  }

  /// Uniform over lower, lower + 1, …, upper.
  int integer(int lower, int upper) {
    return lower + static_cast<int>(bits_() % static_cast<std::uint32_t>(upper - lower + 1));
  }

  /// Uniform over all orientations (Shoemake, *Uniform Random Rotations*, 1992).
  Quat orientation() {
    const Real split = real(0, 1);
    const Real first = real(0, 2 * pi);
    const Real second = real(0, 2 * pi);
    const Real a = std::sqrt(1 - split);
    const Real b = std::sqrt(split);
    const Quat turn(b * cosine(second), a * sine(first), a * cosine(first), b * sine(second));
    return turn.normalized();
  }

 private:
  std::mt19937 bits_;
};

}  // namespace cs550
