#pragma once
/// @file shadow_map.hpp
/// What the light sees.

#include "cs550/math.hpp"
#include "viewer/gl/handle.hpp"
#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

/// Distances from a far light, drawn before the scene, asked while it is drawn.
class ShadowMap {
 public:
  /// @param side pixels
  explicit ShadowMap(int side);

  int side() const { return side_; }

  /// What is drawn from now on is what casts shadows inside a ball.
  /// @return world to the light's clip coordinates
  Matrix4 begin(const Vec3& light, const Vec3& center, Real radius) const;
  /// Makes the distances a texture. @param unit of textures
  void bind(int unit) const;

 private:
  int side_;
  Framebuffer frame_;
  Texture depth_;
};

}  // namespace cs550::viewer
