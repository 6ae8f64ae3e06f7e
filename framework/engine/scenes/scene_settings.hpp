#pragma once
/// @file scene_settings.hpp
/// The "world" object of a scene file.

#include "cs550/world.hpp"
#include "engine/scenes/scene_reader.hpp"

namespace cs550 {

/// Every member of WorldSettings is a key; those that are absent keep their defaults.
WorldSettings read_settings(SceneReader world);

}  // namespace cs550
