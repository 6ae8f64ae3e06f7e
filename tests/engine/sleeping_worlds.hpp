#pragma once
/// @file sleeping_worlds.hpp
/// Worlds that fall asleep, for tests.

#include <algorithm>
#include <vector>

#include "engine/test_bodies.hpp"

namespace cs550::test {

inline WorldSettings sleeping_settings(WorldSettings settings = {}) {
  settings.sleeping = true;
  return settings;
}

inline int sleepers(const World& world) {
  int count = 0;
  for (const RigidBody& body : world.bodies()) count += body.asleep ? 1 : 0;
  return count;
}

inline int moving_bodies(const World& world) {
  int count = 0;
  for (const RigidBody& body : world.bodies()) count += body.kind == BodyKind::Dynamic ? 1 : 0;
  return count;
}

/// Runs until all dynamic bodies sleep. @returns whether they do
inline bool falls_asleep(World& world, int most_steps) {
  for (int i = 0; i < most_steps; ++i) {
    world.step(step_length);
    if (sleepers(world) == moving_bodies(world)) return true;
  }
  return false;
}

/// Two towers of four cubes on a floor, 6 m apart, one after the other.
struct Towers {
  World world;
  BodyId floor;
  std::vector<BodyId> left, right;

  explicit Towers(const WorldSettings& settings = sleeping_settings()) : world(settings) {
    const ShapePtr cube = box_shape(Vec3::Constant(Real(0.5)));
    floor = world.add_body(floor_body());
    for (int i = 0; i < 4; ++i) {
      const Real height = Real(0.5) + static_cast<Real>(i);
      left.push_back(world.add_body(body_at(cube, {-3, 0, height})));
      right.push_back(world.add_body(body_at(cube, {3, 0, height})));
    }
  }

  bool is_asleep(const std::vector<BodyId>& tower) const {
    return std::all_of(tower.begin(), tower.end(),
                       [&](BodyId id) { return !world.is_alive(id) || world.body(id).asleep; });
  }
};

}  // namespace cs550::test
