#pragma once
/// @file canvas.hpp
/// Where a frame is drawn before it reaches a window or a file.

#include "viewer/gl/handle.hpp"

namespace cs550::viewer {

/// In pixels.
struct Size {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  bool operator==(const Size& other) const {
    return width == other.width && height == other.height;
  }
};

/// A smooth canvas: several samples per pixel for what is three-dimensional, and one sample per
/// pixel, with the smooth picture in it, for the panels on top.
class Canvas {
 public:
  explicit Canvas(Size size);

  Size size() const { return size_; }
  /// What is drawn from now on goes to the many samples.
  void begin_scene() const;
  /// Averages the samples. What is drawn from now on goes on top of the result.
  void resolve() const;
  /// Shows the canvas in the window's own frame, and goes on drawing there.
  void show_in_window() const;
  /// The framebuffer that holds the result.
  GLuint result() const { return result_.name(); }

 private:
  Size size_;
  Framebuffer samples_;
  Renderbuffer sample_colour_;
  Renderbuffer sample_depth_;
  Framebuffer result_;
  Renderbuffer result_colour_;
};

}  // namespace cs550::viewer
