#pragma once
/// @file content_renderer.hpp
/// The picture of a page, without panels.

#include "pages/base/content.hpp"
#include "viewer/gl/canvas.hpp"
#include "viewer/render/ink_renderer.hpp"
#include "viewer/render/solid_renderer.hpp"

namespace cs550::viewer {

using namespace pages;

/// Paints contents.
class ContentRenderer {
 public:
  /// Paints to a canvas, unless it holds the same picture already. A canvas belongs to one painter.
  /// @param scale of line widths
  void paint(const Content& content, const Projection& projection, Canvas& canvas, float scale);
  /// How often the same was painted since the last change.
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
