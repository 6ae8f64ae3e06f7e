#pragma once
/// @file scene_generators.hpp
/// Many bodies from a few lines of a scene file.

#include <vector>

#include "engine/scenes/scene_bodies.hpp"

namespace cs550 {

/// The bodies of one entry of "generators". Refuses too many before it makes any.
/// @param cost to which the bodies and the vertices of their shapes are added
std::vector<NamedBody> generate_bodies(SceneReader generator, const SceneShapes& shapes,
                                       SceneCost& cost);

}  // namespace cs550
