#pragma once
/// @file canvas.hpp
/// The framebuffer of a frame, before it is shown in a window or written to a file.

#include <cstdint>

#include "pages/base/area.hpp"
#include "viewer/gl/handle.hpp"

namespace cs550::viewer {

using namespace pages;

/// How a frame is sampled. Multisampling is slow without a GPU.
enum class RenderQuality : std::uint8_t {
  Fine,   ///< several samples per pixel: for pictures, and for windows with a GPU
  Quick,  ///< one sample: for windows without a GPU while anything moves
};

/// A frame: first the 3D scene, then the panels on top of it.
class Canvas {
 public:
  explicit Canvas(Size size, RenderQuality quality = RenderQuality::Fine);

  Size size() const { return size_; }
  RenderQuality quality() const { return quality_; }
  /// Begins the 3D scene. @param scene its number, for holds()
  void begin_scene(int scene);
  /// Whether the canvas still holds that scene, without panels, so that it need not be drawn again.
  bool holds(int scene) const { return held_ == scene; }
  /// Averages the samples. Later drawing is on top of the result.
  void resolve() const;
  /// Copies the canvas to the window's own framebuffer, where drawing continues.
  void show_in_window() const;
  /// The framebuffer that holds the result.
  GLuint result() const { return result_.name(); }

 private:
  Size size_;
  RenderQuality quality_;
  int held_ = 0;         ///< number of the scene in samples_; 0: none
  Framebuffer samples_;  ///< of a fine canvas
  Renderbuffer sample_colour_;
  Framebuffer result_;
  Renderbuffer result_colour_;
  Renderbuffer depth_;
};

/// Whether OpenGL runs on the CPU.
bool draws_in_software();

}  // namespace cs550::viewer
