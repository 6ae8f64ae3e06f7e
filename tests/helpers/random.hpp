#pragma once
/// @file random.hpp
/// Random inputs that are the same with every compiler and library.

#include <cstdint>
#include <random>

#include "cs550/math.hpp"

namespace cs550::test {

/// std::mt19937 is specified bit for bit, the distributions of <random> are not: hence our own.
class Random {
 public:
  explicit Random(std::uint32_t seed) : seed_(seed), bits_(seed) {}

  std::uint32_t seed() const { return seed_; }

  /// Uniform in [lower, upper).
  Real real(Real lower, Real upper) {
    const double unit = static_cast<double>(bits_()) / 4294967296.0;
    return static_cast<Real>(lower + (static_cast<double>(upper) - lower) * unit);
  }

  /// Uniform in [lower, upper], both included.
  int integer(int lower, int upper) {
    return lower + static_cast<int>(bits_() % static_cast<std::uint32_t>(upper - lower + 1));
  }

  Vec3 point_in_box(const Vec3& half_extents) {
    Vec3 point;
    for (int i = 0; i < 3; ++i) point[i] = real(-half_extents[i], half_extents[i]);
    return point;
  }

  /// Uniform on the sphere (Archimedes: the height is uniform).
  Vec3 unit_vector() {
    const Real z = real(-1, 1);
    const Real angle = real(0, 2 * pi);
    const Real radius = std::sqrt(std::max(Real(0), 1 - z * z));
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

  /// Uniform over all orientations (Shoemake 1992).
  Quat orientation() {
    const Real split = real(0, 1);
    const Real first = real(0, 2 * pi);
    const Real second = real(0, 2 * pi);
    const Real a = std::sqrt(1 - split);
    const Real b = std::sqrt(split);
    return Quat(b * std::cos(second), a * std::sin(first), a * std::cos(first),
                b * std::sin(second))
        .normalized();
  }

 private:
  std::uint32_t seed_;
  std::mt19937 bits_;
};

}  // namespace cs550::test
