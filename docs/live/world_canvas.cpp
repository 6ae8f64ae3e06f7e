#include "world_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "body_order.hpp"
#include "pages/base/colours.hpp"
#include "pages/base/cutaway.hpp"

namespace cs550::live {

namespace {

using pages::Rgba;

enum Kind { Polygon, Line, DashedLine, Arrow, DashedArrow, Dot };

constexpr std::size_t most_outlined =
    5000;  ///< faces; with more, outlines would take longer than faces

/// The colour under a fixed light from above.
Rgba lit(const Rgba& colour, const Vec3& normal) {
  const Vec3 light = Vec3(Real(0.4), Real(-0.5), Real(0.77)).normalized();
  const float bright = 0.66F + 0.34F * std::max(0.0F, normal.dot(light));
  Rgba shaded = bright * colour;
  shaded.w() = colour.w();
  return shaded;
}

/// As canvases take it: 0xRRGGBB, exact in a float.
float packed(const Rgba& colour) {
  const auto byte = [](float part) { return std::round(255 * std::clamp(part, 0.0F, 1.0F)); };
  return 65536 * byte(colour.x()) + 256 * byte(colour.y()) + byte(colour.z());
}

pages::Projection project(const pages::Camera& camera, pages::Size canvas) {
  return {
      camera, canvas, {0, 0, static_cast<float>(canvas.width), static_cast<float>(canvas.height)}};
}

bool all_in_front(const std::vector<Vec3>& corners, const pages::Projection& seen) {
  return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
    return (corner - seen.eye()).dot(seen.forward()) >= seen.nearest();
  });
}

/// A quadrilateral as cells, which overlap a little so that no seams show.
std::vector<std::vector<Vec3>> cells(const std::vector<Vec3>& corners) {
  constexpr int count = 24;  // per side
  const auto at = [&](Real s, Real t) -> Vec3 {
    return (1 - t) * ((1 - s) * corners[0] + s * corners[1]) +
           t * ((1 - s) * corners[3] + s * corners[2]);
  };
  std::vector<std::vector<Vec3>> result;
  result.reserve(std::size_t{count * count});
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const Real s = Real(i) / count, s_end = (Real(i) + Real(1.02)) / count;
      const Real t = Real(j) / count, t_end = (Real(j) + Real(1.02)) / count;
      result.push_back({at(s, t), at(s_end, t), at(s_end, t_end), at(s, t_end)});
    }
  }
  return result;
}

}  // namespace

WorldCanvas::WorldCanvas(pages::WorldPage& page, pages::Camera& camera)
    : page_(page), camera_(camera), seen_(project(camera, {1, 1})) {}

const std::vector<float>& WorldCanvas::paint(pages::Size canvas) {
  page_.refresh();
  const pages::Focus& focus = page_.content().focus;
  if (!is_framed_) camera_ = pages::fitted(camera_, focus.center, focus.radius);
  is_framed_ = true;
  seen_ = project(camera_, canvas);
  shapes_.clear();
  add_solids();
  add_overlays();
  return shapes_;
}

void WorldCanvas::begin(float kind, const Rgba& colour, float size, std::size_t points) {
  shapes_.insert(shapes_.end(),
                 {kind, packed(colour), colour.w(), size, static_cast<float>(points)});
}

void WorldCanvas::add(const Vec3& point) {
  const Vec2 pixel = seen_.pixel(point);
  shapes_.insert(shapes_.end(), {pixel.x(), pixel.y()});
}

void WorldCanvas::add_solids() {
  std::vector<pages::Solid> solids = page_.content().solids;
  pages::open_view(solids, camera_.eye());
  std::size_t faces = 0;
  for (const pages::Solid& solid : solids) faces += solid.mesh->faces.size() / 2;
  const float outline = faces > most_outlined ? 0.0F : 1.0F;
  for (const std::size_t i : back_to_front(solids, seen_)) {
    for (Index face = 0; face < solids[i].mesh->face_count(); ++face) {
      add_face(solids[i], face, outline);
    }
  }
}

void WorldCanvas::add_face(const pages::Solid& solid, Index face, float outline) {
  const HalfEdgeMesh& mesh = *solid.mesh;
  const Plane& plane = mesh.face(face).plane;
  if (plane.distance(solid.pose.to_body(camera_.eye())) <= 0) return;
  std::vector<Vec3> corners;
  for (const Index e : face_edges(mesh, face)) {
    corners.push_back(solid.pose.to_world(mesh.vertex(mesh.origin(e))));
  }
  const Rgba colour = lit(solid.colour, solid.pose.rotate(plane.normal));
  if (all_in_front(corners, seen_)) {
    add_polygon(colour, outline, corners);
  } else if (corners.size() == 4) {  // a floor that reaches behind the camera
    for (const std::vector<Vec3>& cell : cells(corners)) {
      if (all_in_front(cell, seen_)) add_polygon(colour, 0, cell);
    }
  }
}

void WorldCanvas::add_polygon(const Rgba& colour, float outline, const std::vector<Vec3>& corners) {
  begin(Polygon, colour, outline, corners.size());
  for (const Vec3& corner : corners) add(corner);
}

void WorldCanvas::add_line(const drawing::Line& line) {
  if (!seen_.is_in_front(line.from) || !seen_.is_in_front(line.to)) return;
  const auto& [role, width, dashed, arrow] = line.stroke;
  const Kind kind = arrow ? (dashed ? DashedArrow : Arrow) : (dashed ? DashedLine : Line);
  begin(static_cast<float>(kind), pages::role_rgba(role), width, 2);
  add(line.from);
  add(line.to);
}

void WorldCanvas::add_overlays() {
  const drawing::Drawing& drawing = page_.content().drawing;
  for (const drawing::Line& line : drawing.lines) add_line(line);
  for (const drawing::Point& point : drawing.points) {
    if (!seen_.is_in_front(point.position)) continue;
    begin(Dot, pages::role_rgba(point.role), point.radius, 1);
    add(point.position);
  }
}

std::string WorldCanvas::words() const {
  const drawing::Drawing& drawing = page_.content().drawing;
  nlohmann::json labels = nlohmann::json::array();
  for (const drawing::Label& label : drawing.labels) {
    if (!seen_.is_in_front(label.position)) continue;
    const Vec2 pixel = seen_.pixel(label.position);
    labels.push_back({{"x", pixel.x()}, {"y", pixel.y()}, {"text", label.text}});
  }
  nlohmann::json legend = nlohmann::json::array();
  for (const drawing::LegendEntry& entry : drawing.legend) {
    legend.push_back({{"text", entry.text}, {"colour", hex(drawing::colour(entry.stroke.role))}});
  }
  return nlohmann::json{{"labels", labels}, {"legend", legend}, {"notes", drawing.notes}}.dump();
}

bool WorldCanvas::press(const Vec2& pixel) {
  const auto hit = page_.pick(seen_.eye(), seen_.ray(pixel));
  const bool can_move = hit && page_.frame().bodies[hit->body].kind == BodyKind::Dynamic;
  page_.select(can_move ? std::optional(hit->body) : std::nullopt);
  if (!can_move) return false;
  page_.grab(*hit);
  depth_ = (hit->point - seen_.eye()).dot(seen_.forward());
  return true;
}

void WorldCanvas::pull(const Vec2& pixel) {
  const Vec3 ray = seen_.ray(pixel);
  page_.drag_to(seen_.eye() + depth_ / ray.dot(seen_.forward()) * ray);
}

void WorldCanvas::select_next() {
  const auto& bodies = page_.frame().bodies;
  Index next = page_.selected() ? *page_.selected() + 1 : 0;
  const auto count = static_cast<Index>(bodies.size());
  while (next < count &&
         (bodies[next].kind != BodyKind::Dynamic || page_.frame().is_alive[next] == 0)) {
    ++next;
  }
  page_.select(next < count ? std::optional(next) : std::nullopt);
}

void WorldCanvas::throw_box(const Vec2& pixel) {
  page_.throw_box(camera_.eye(), camera_.eye() + seen_.ray(pixel));
}

}  // namespace cs550::live
