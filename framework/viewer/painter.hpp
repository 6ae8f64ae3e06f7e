#pragma once
/// @file painter.hpp
/// The picture of a page, without panels.

#include "viewer/content.hpp"
#include "viewer/render/ink_renderer.hpp"
#include "viewer/render/solid_renderer.hpp"

namespace cs550::viewer {

/// Paints contents.
class Painter {
 public:
  /// Paints to a canvas. @param scale of line widths
  void paint(const Content& content, const Projection& projection, const Canvas& canvas,
             float scale);

 private:
  Backdrop backdrop_;
  SolidRenderer solids_;
  InkRenderer ink_;
};

}  // namespace cs550::viewer
