#pragma once
/// @file backdrop.hpp
/// The background of a picture.

#include "viewer/gl/handle.hpp"
#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

/// GLSL: `vec3 backdrop(float height)`, linear light, height 0 at the bottom and 1 at the top.
extern const char* const backdrop_source;

/// A soft gradient, like the paper of a photo studio.
class Backdrop {
 public:
  Backdrop();
  /// Fills the pixels that nothing opaque covers.
  void draw(float height_pixels) const;

 private:
  Shader shader_;
  VertexArray empty_;
};

}  // namespace cs550::viewer
