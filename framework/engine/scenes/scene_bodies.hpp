#pragma once
/// @file scene_bodies.hpp
/// One body of a scene file.

#include "cs550/scene.hpp"
#include "engine/scenes/scene_reader.hpp"
#include "engine/scenes/scene_shapes.hpp"

namespace cs550 {

/// A body and what it is called.
struct NamedBody {
  BodyDef def;
  std::string name;
};

/// Everything of a body but its shape. Leaves the refusal of other keys to the caller.
NamedBody read_body_without_shape(SceneReader& body);

/// A whole body.
NamedBody read_body(SceneReader body, const SceneShapes& shapes);

}  // namespace cs550
