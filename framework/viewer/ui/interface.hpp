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
  /// @param scale of what is drawn where there is room for it
  Interface(GLFWwindow* window, float scale);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  /// Between these two, widgets are made; they are smaller where there is little room for panels.
  /// @param canvas pixels, @param has_panels what is drawn without panels never shrinks
  void begin_frame(Size canvas, bool has_panels);
  /// Draws them to what is drawn to at present.
  void end_frame();

  const Fonts& fonts() const { return fonts_; }
  /// Of the present frame.
  float scale() const { return scale_; }

 private:
  Size size_for(Size canvas) const;
  void set_scale(float scale);

  GLFWwindow* window_;
  float full_scale_;
  float scale_;
  Fonts fonts_;
};

}  // namespace cs550::viewer
