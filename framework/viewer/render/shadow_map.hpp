#pragma once
/// @file shadow_map.hpp
/// The depth map for shadows.

#include "cs550/math.hpp"
#include "viewer/gl/handle.hpp"
#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

/// Distances from a directional light. They are drawn before the scene and sampled while it is
/// drawn.
class ShadowMap {
 public:
  /// @param side pixels
  explicit ShadowMap(int side);

  int side() const { return side_; }

  /// Begins the shadow casters inside a ball.
  /// @return the matrix from world to the light's clip coordinates
  Matrix4 begin(const Vec3& light, const Vec3& center, Real radius) const;
  /// Binds the distances as a texture. @param unit texture unit
  void bind(int unit) const;

 private:
  int side_;
  Framebuffer frame_;
  Texture depth_;
};

}  // namespace cs550::viewer
