#pragma once
/// @file scene_generators.hpp
/// Many bodies from a few lines of a scene file.

#include <vector>

#include "engine/scenes/scene_bodies.hpp"

namespace cs550 {

/// The bodies that one entry of "generators" stands for.
std::vector<NamedBody> generate_bodies(SceneReader generator, const SceneShapes& shapes);

}  // namespace cs550
