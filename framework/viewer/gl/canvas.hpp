#pragma once
/// @file canvas.hpp
/// Where a frame is drawn before it reaches a window or a file.

#include <cstdint>

#include "pages/base/area.hpp"
#include "viewer/gl/handle.hpp"

namespace cs550::viewer {

using namespace pages;

/// How much work a frame may be.
enum class Quality : std::uint8_t {
  Fine,   ///< several samples per pixel: pictures, and windows on a graphics card
  Quick,  ///< one sample: a window that a processor draws, as long as something moves
};

/// What a frame is drawn on: what is three-dimensional first, panels on top of it.
class Canvas {
 public:
  explicit Canvas(Size size, Quality quality = Quality::Fine);

  Size size() const { return size_; }
  Quality quality() const { return quality_; }
  /// What is drawn from now on is three-dimensional. @param scene its number, for holds()
  void begin_scene(int scene);
  /// Whether that scene is still there without the panels: it need not be drawn again.
  bool holds(int scene) const { return held_ == scene; }
  /// Averages the samples. What is drawn from now on goes on top of the result.
  void resolve() const;
  /// Shows the canvas in the window's own frame, and goes on drawing there.
  void show_in_window() const;
  /// The framebuffer that holds the result.
  GLuint result() const { return result_.name(); }

 private:
  Size size_;
  Quality quality_;
  int held_ = 0;         ///< number of the scene in samples_; 0: none
  Framebuffer samples_;  ///< of a fine canvas
  Renderbuffer sample_colour_;
  Framebuffer result_;
  Renderbuffer result_colour_;
  Renderbuffer depth_;
};

/// Whether the processor does the graphics card's work.
bool draws_in_software();

}  // namespace cs550::viewer
