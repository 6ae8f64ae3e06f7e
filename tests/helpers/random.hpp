#pragma once
/// @file random.hpp
/// Random inputs that do not depend on the compiler and the library.

#include "engine/scenes/scene_random.hpp"

namespace cs550::test {

/// What is added to every seed: the environment variable CS550_SEED_SALT, 0 if it is absent. An
/// instructor's course has a salt of its own, so that no table of the published random inputs earns points.
std::uint32_t seed_salt();

/// The generator of scenes, with further distributions for tests.
class Random : public SceneRandom {
 public:
  explicit Random(std::uint32_t seed) : SceneRandom(seed + seed_salt()), seed_(seed) {}

  /// As published, without the salt.
  std::uint32_t seed() const { return seed_; }

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

 private:
  std::uint32_t seed_;
};

}  // namespace cs550::test
