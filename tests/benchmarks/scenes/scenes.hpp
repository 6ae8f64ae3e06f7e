#pragma once
/// @file scenes.hpp
/// The scenes that every engine runs. All of them have friction 0.6, no restitution, a density of
/// 1000 kg/m³ and gravity of 9.81 m/s² along −z.

#include <span>
#include <vector>

#include "cs550/world.hpp"

namespace cs550::bench {

/// A scene in the terms of the contract, from which each engine makes its own bodies.
struct BenchScene {
  std::vector<BodyDef> bodies;  ///< shapes in principal axes: their inertia is diagonal
  bool stays_upright = false;   ///< bodies should never move sideways
  Real half_width = 0;          ///< of the room, along x and y: beyond it a body is lost (m)
};

/// A scene of the comparison. Making it takes up to a second.
struct NamedScene {
  const char* name;   ///< S1
  const char* title;  ///< a few words
  BenchScene (*make)();
};

/// S1 to S5b.
std::span<const NamedScene> compared_scenes();

/// across² columns of ten cubes in a room, which fall onto each other and stay upright.
BenchScene columns_of_cubes(int across);
/// across² × layers random hulls of a diameter of 1 m, which fall into a room.
BenchScene pile_of_hulls(int across, int layers, int vertices);
/// The same pile with only `shapes` different hulls, which the bodies use in turn.
BenchScene pile_of_shared_hulls(int across, int layers, int vertices, std::size_t shapes);
/// across² cubes that never touch.
BenchScene lone_cubes(int across);

/// Whether a shape is a box about its origin, along its axes.
bool is_box(const ConvexShape& shape);
/// Half the extent of its bounds (m).
Vec3 half_extents_of_box(const ConvexShape& shape);
/// Whether all bodies are boxes.
bool has_only_boxes(const BenchScene& scene);

}  // namespace cs550::bench
