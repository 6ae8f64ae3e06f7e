#include "viewer/render/content_renderer.hpp"

#include "pages/base/cutaway.hpp"

namespace cs550::viewer {

using namespace pages;

/// @return whether the picture has changed
bool ContentRenderer::set(const Content& content, const Projection& projection, float scale) {
  std::vector<Solid> solids = content.solids;
  open_view(solids, projection.eye());
  const bool is_seen_anew = projection.matrix() != seen_;
  const bool are_others = solids_.set(solids, content.focus);
  const bool is_drawn_anew = ink_.begin(content.drawing, scale, projection.eye());
  seen_ = projection.matrix();
  return is_seen_anew || are_others || is_drawn_anew;
}

void ContentRenderer::paint(const Content& content, const Projection& projection, Canvas& canvas,
                            float scale) {
  if (set(content, projection, scale)) {
    ++scene_;
    still_frames_ = 0;
  } else {
    ++still_frames_;
  }
  if (canvas.holds(scene_)) {
    canvas.resolve();
    return;
  }
  solids_.begin(projection, canvas.quality());
  canvas.begin_scene(scene_);
  glClear(GL_DEPTH_BUFFER_BIT);
  solids_.draw_opaque(projection, canvas.size());
  backdrop_.draw(static_cast<float>(canvas.size().height));
  ink_.draw_areas(projection);
  solids_.draw_translucent(projection, canvas.size());
  ink_.draw_strokes(projection, canvas.size());
  canvas.resolve();
}

}  // namespace cs550::viewer
