#pragma once
/// @file interface.hpp
/// Dear ImGui and what belongs to it, for a window or for a picture.

#include "viewer/gl/canvas.hpp"
#include "viewer/ui/theme.hpp"

struct GLFWwindow;

namespace cs550::viewer {

/// Owns Dear ImGui's context. At most one at a time; OpenGL is current.
class Interface {
 public:
  /// @param window whose mouse and keys it hears; none for a picture
  Interface(GLFWwindow* window, float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Between these two, widgets are made. @param size of the canvas
  void begin_frame(Size size);
  /// Draws them to what is drawn to at present.
  void end_frame();

  const Fonts& fonts() const { return fonts_; }
  float scale() const { return scale_; }

 private:
  GLFWwindow* window_;
  float scale_;
  Fonts fonts_;
};

}  // namespace cs550::viewer
