#include "viewer/render/ink_renderer.hpp"

#include <algorithm>

#include "viewer/render/ink_shaders.hpp"

namespace cs550::viewer {
namespace {

using drawing::Drawing;
using drawing::Role;

constexpr float hidden_opacity = 0.22F;       ///< of hidden strokes
constexpr Real covering_opacity = Real(0.7);  ///< at which a polygon hides strokes behind it
constexpr Real outline = Real(1.2);  ///< pixels around a stroke too light for a white background

void append(std::vector<float>& floats, const Vec3& v) {
  floats.insert(floats.end(), {v.x(), v.y(), v.z()});
}
void append(std::vector<float>& floats, const Rgba& c) {
  floats.insert(floats.end(), {c.x(), c.y(), c.z(), c.w()});
}

/// @param rim pixels by which the stroke is widened on every side
void append_line(std::vector<float>& floats, const drawing::Line& line, const Rgba& colour,
                 float scale, float rim) {
  append(floats, line.from);
  append(floats, line.to);
  append(floats, colour);
  floats.insert(floats.end(), {line.stroke.width * scale, line.stroke.dashed ? 1.0F : 0.0F,
                               line.stroke.arrow ? 1.0F : 0.0F, rim});
}

std::vector<float> line_records(const Drawing& drawing, float scale) {
  std::vector<float> floats;
  for (const drawing::Line& line : drawing.lines) {
    if (drawing::needs_outline(line.stroke.role)) {
      append_line(floats, line, role_rgba(Role::Text), scale, outline * scale);
    }
    append_line(floats, line, role_rgba(line.stroke.role), scale, 0);
  }
  return floats;
}

std::vector<float> dot_records(const Drawing& drawing, float scale) {
  std::vector<float> floats;
  for (const drawing::Point& point : drawing.points) {
    if (drawing::needs_outline(point.role)) {
      append(floats, point.position);
      append(floats, role_rgba(Role::Text));
      floats.push_back((point.radius + outline) * scale);
    }
    append(floats, point.position);
    append(floats, role_rgba(point.role));
    floats.push_back(point.radius * scale);
  }
  return floats;
}

bool covers(const drawing::Polygon& polygon) { return polygon.opacity >= covering_opacity; }

Real distance(const drawing::Polygon& polygon, const Vec3& eye) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : polygon.corners) sum += corner - eye;
  return sum.norm() / static_cast<Real>(std::max<std::size_t>(polygon.corners.size(), 1));
}

/// First the polygons that hide strokes, then the others; each group from back to front.
std::vector<const drawing::Polygon*> in_order(const Drawing& drawing, const Vec3& eye) {
  std::vector<const drawing::Polygon*> order;
  for (const drawing::Polygon& polygon : drawing.polygons) order.push_back(&polygon);
  std::stable_sort(order.begin(), order.end(), [&](const auto* a, const auto* b) {
    if (covers(*a) != covers(*b)) return covers(*a);
    return distance(*a, eye) > distance(*b, eye);
  });
  return order;
}

std::vector<float> triangle_records(std::span<const drawing::Polygon* const> polygons) {
  std::vector<float> floats;
  for (const drawing::Polygon* polygon : polygons) {
    const Rgba colour = role_rgba(polygon->role, polygon->opacity);
    for (std::size_t i = 2; i < polygon->corners.size(); ++i) {
      for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
        append(floats, polygon->corners[corner]);
        append(floats, colour);
      }
    }
  }
  return floats;
}

GLsizei count_covering_vertices(const Drawing& drawing) {
  std::size_t count = 0;
  for (const drawing::Polygon& polygon : drawing.polygons) {
    if (covers(polygon) && polygon.corners.size() > 2) count += 3 * (polygon.corners.size() - 2);
  }
  return static_cast<GLsizei>(count);
}

std::vector<float> ball_records(const Drawing& drawing) {
  std::vector<float> floats;
  for (const drawing::Ball& ball : drawing.balls) {
    append(floats, ball.center);
    floats.push_back(ball.radius);
    append(floats, role_rgba(ball.role, ball.opacity));
  }
  return floats;
}

void set_camera(const Shader& shader, const Projection& projection) {
  shader.use();
  shader.set("camera", projection.matrix());
  shader.set("eye", projection.eye());
}

void begin_blending() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
}

void end_blending() {
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

}  // namespace

InkRenderer::InkRenderer()
    : line_shader_("line", ink_shaders::line_vertex, ink_shaders::line_fragment),
      dot_shader_("dot", ink_shaders::dot_vertex, ink_shaders::dot_fragment),
      polygon_shader_("polygon", ink_shaders::polygon_vertex, ink_shaders::polygon_fragment),
      ball_shader_("ball", ink_shaders::ball_vertex, ink_shaders::ball_fragment) {}

/// Fills a buffer and sets its vertex format. @return whether the contents have changed
bool InkRenderer::fill(Batch& batch, std::vector<float> records, std::initializer_list<GLint> parts,
                       GLuint divisor) {
  if (records == batch.records) return false;
  GLint record = 0;
  for (const GLint part : parts) record += part;
  glBindVertexArray(batch.layout.name());
  glBindBuffer(GL_ARRAY_BUFFER, batch.buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(records.size() * sizeof(float)),
               records.data(), GL_STREAM_DRAW);
  GLuint place = 0;
  std::uintptr_t offset = 0;
  for (const GLint part : parts) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, part, GL_FLOAT, GL_FALSE,
                          record * static_cast<GLsizei>(sizeof(float)), buffer_offset(offset));
    glVertexAttribDivisor(place, divisor);
    offset += static_cast<std::uintptr_t>(part) * sizeof(float);
    ++place;
  }
  batch.count = static_cast<GLsizei>(records.size()) / record;
  batch.records = std::move(records);
  return true;
}

bool InkRenderer::begin(const Drawing& drawing, float scale, const Vec3& eye) {
  const int changes = fill(lines_, line_records(drawing, scale), {3, 3, 4, 4}, 1) +
                      fill(dots_, dot_records(drawing, scale), {3, 4, 1}, 1) +
                      fill(triangles_, triangle_records(in_order(drawing, eye)), {3, 4}, 0) +
                      fill(balls_, ball_records(drawing), {4, 4}, 1);
  covering_ = count_covering_vertices(drawing);
  return changes > 0;
}

void InkRenderer::draw_areas(const Projection& projection) const {
  glEnable(GL_DEPTH_TEST);
  begin_blending();
  set_camera(ball_shader_, projection);
  // Balls hide what is drawn later behind them, so they write depth.
  glDepthMask(GL_TRUE);
  glBindVertexArray(balls_.layout.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, balls_.count);
  set_camera(polygon_shader_, projection);
  glBindVertexArray(triangles_.layout.name());
  glDrawArrays(GL_TRIANGLES, 0, covering_);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, covering_, triangles_.count - covering_);
  end_blending();
}

void InkRenderer::draw_both(const Shader& shader, const Batch& batch, const Projection& projection,
                            Size canvas) const {
  if (batch.count == 0) return;
  set_camera(shader, projection);
  shader.set("forward", projection.forward());
  shader.set("nearest", projection.nearest());
  shader.set("canvas", Vec2(static_cast<float>(canvas.width), static_cast<float>(canvas.height)));
  glBindVertexArray(batch.layout.name());
  glDepthFunc(GL_GREATER);
  shader.set("opacity", hidden_opacity);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.count);
  glDepthFunc(GL_LEQUAL);
  shader.set("opacity", 1.0F);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.count);
}

void InkRenderer::draw_strokes(const Projection& projection, Size canvas) const {
  glEnable(GL_DEPTH_TEST);
  begin_blending();
  draw_both(line_shader_, lines_, projection, canvas);
  draw_both(dot_shader_, dots_, projection, canvas);
  end_blending();
}

}  // namespace cs550::viewer
