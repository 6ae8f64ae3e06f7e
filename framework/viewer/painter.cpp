#include "viewer/painter.hpp"

#include "viewer/render/cutaway.hpp"

namespace cs550::viewer {

void Painter::paint(const Content& content, const Projection& projection, const Canvas& canvas,
                    float scale) {
  std::vector<Solid> solids = content.solids;
  open_view(solids, projection.eye());
  solids_.begin(solids, content.focus);
  ink_.begin(content.drawing, scale, projection.eye());
  canvas.begin_scene();
  glClear(GL_DEPTH_BUFFER_BIT);
  backdrop_.draw(static_cast<float>(canvas.size().height));
  solids_.draw_opaque(projection, canvas.size());
  ink_.draw_areas(projection);
  solids_.draw_translucent(projection, canvas.size());
  ink_.draw_strokes(projection, canvas.size());
  canvas.resolve();
}

}  // namespace cs550::viewer
