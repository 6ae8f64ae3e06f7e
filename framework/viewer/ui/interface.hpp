#pragma once
/// @file interface.hpp
/// The context of Dear ImGui, for a window or a picture.

#include "viewer/gl/canvas.hpp"
#include "viewer/ui/theme.hpp"

struct GLFWwindow;

namespace cs550::viewer {

/// Owns Dear ImGui's context. At most one at a time. @pre an OpenGL context is current
class Interface {
 public:
  /// @param window the source of mouse and key events; null for a picture
  /// @param scale of text and widgets if there is enough room
  Interface(GLFWwindow* window, float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Begins a frame. Widgets are created between begin and end, smaller if there is little room.
  /// @param canvas pixels, @param has_panels without panels nothing is made smaller
  void begin_frame(Size canvas, bool has_panels);
  /// Draws the widgets to the current framebuffer.
  void end_frame();

  /// Time since the present frame began (s). Without a window no time passes within a frame.
  double time_in_frame() const;

  const Fonts& fonts() const { return fonts_; }
  /// Of the present frame.
  float scale() const { return scale_; }

 private:
  Size size_for(Size canvas) const;
  void set_scale(float scale);

  GLFWwindow* window_;
  float full_scale_;
  float scale_;
  double frame_start_ = 0;  ///< on GLFW's clock (s)
  Fonts fonts_;
};

}  // namespace cs550::viewer
