#pragma once
/// @file backdrop.hpp
/// What is behind everything.

#include "viewer/gl/handle.hpp"
#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

/// GLSL: `vec3 backdrop(float height)`, linear light, height 0 at the bottom and 1 at the top.
extern const char* const backdrop_source;

/// A quiet gradient, like paper in a studio.
class Backdrop {
 public:
  Backdrop();
  /// Covers what nothing opaque has covered.
  void draw(float height_pixels) const;

 private:
  Shader shader_;
  VertexArray empty_;
};

}  // namespace cs550::viewer
