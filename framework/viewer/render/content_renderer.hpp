#pragma once
/// @file content_renderer.hpp
/// The picture of a page, without panels.

#include "pages/base/content.hpp"
#include "viewer/gl/canvas.hpp"
#include "viewer/render/ink_renderer.hpp"
#include "viewer/render/solid_renderer.hpp"

namespace cs550::viewer {

using namespace pages;

/// Draws the content of a page.
class ContentRenderer {
 public:
  /// Draws to a canvas, unless it already holds the same picture. A canvas belongs to one renderer.
  /// @param scale of line widths
  void paint(const Content& content, const Projection& projection, Canvas& canvas, float scale);
  /// How many frames in a row were unchanged.
  int still_frames() const { return still_frames_; }

 private:
  bool set(const Content& content, const Projection& projection, float scale);

  int scene_ = 0;  ///< number of the present picture
  int still_frames_ = 0;
  Matrix4 seen_ = Matrix4::Zero();
  Backdrop backdrop_;
  SolidRenderer solids_;
  InkRenderer ink_;
};

}  // namespace cs550::viewer
