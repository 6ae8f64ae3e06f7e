#pragma once
/// @file shader.hpp
/// Programs that run on the GPU.

#include <epoxy/gl.h>

#include "pages/base/camera.hpp"
#include "pages/base/colours.hpp"

namespace cs550::viewer {

using namespace pages;

/// A linked vertex and fragment shader.
class Shader {
 public:
  /// @param name for error messages, @param vertex, fragment GLSL 3.30 without the #version line
  /// @throws std::runtime_error with the compiler's message
  Shader(const char* name, const char* vertex, const char* fragment);
  ~Shader();
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  /// Selects it for drawing.
  void use() const;
  /// Sets a uniform; the shader must be in use. Unknown names are ignored, as OpenGL does.
  /// @{
  void set(const char* name, const Matrix4& value) const;
  void set(const char* name, const Vec3& value) const;
  void set(const char* name, const Vec2& value) const;
  void set(const char* name, const Rgba& value) const;
  void set(const char* name, float value) const;
  void set(const char* name, int value) const;
  /// @}

 private:
  GLuint program_;
};

}  // namespace cs550::viewer
