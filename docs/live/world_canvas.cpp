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

enum Kind { Polygon, Line, DashedLine, Arrow, DashedArrow, Dot, Segments };

constexpr std::size_t most_outlined =
    5000;                           ///< faces; with more, outlines would take longer than faces
constexpr Real least_outlined = 8;  ///< pixels; smaller bodies would be all outline

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

bool is_far_enough(const Vec3& point, const pages::Projection& seen) {
  return (point - seen.eye()).dot(seen.forward()) >= seen.nearest();
}

bool all_in_front(const std::vector<Vec3>& corners, const pages::Projection& seen) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec3& corner) { return is_far_enough(corner, seen); });
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
  follow();
  if (!is_framed_) camera_ = pages::fitted(camera_, focus.center, focus.radius);
  is_framed_ = true;
  canvas_ = canvas;
  seen_ = project(camera_, canvas);
  shapes_.clear();
  add_solids();
  add_overlays();
  return shapes_;
}

void WorldCanvas::describe(pages::ControlVisitor& visit) {
  visit.toggle({"follow", "camera follows", ""}, follows_);
}

void WorldCanvas::follow() {
  const std::optional<Index> selected = page_.selected();
  const auto& bodies = page_.frame().bodies;
  Vec3 subject = Vec3::Zero();
  Real count = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool counts = selected ? static_cast<Index>(i) == *selected
                                 : bodies[i].kind == BodyKind::Dynamic && page_.frame().is_alive[i];
    if (!counts) continue;
    subject += bodies[i].pose.position;
    ++count;
  }
  if (count > 0) subject /= count;
  const bool is_same = selected == followed_ && count == followed_count_;
  if (follows_ && is_framed_ && is_same) camera_.target += subject - subject_;
  subject_ = subject;
  followed_ = selected;
  followed_count_ = count;
}

std::size_t WorldCanvas::begin(float kind, const Rgba& colour, float size) {
  shapes_.insert(shapes_.end(), {kind, packed(colour), colour.w(), size, 0});
  return shapes_.size();
}

void WorldCanvas::add(const Vec2& pixel) { shapes_.insert(shapes_.end(), {pixel.x(), pixel.y()}); }

void WorldCanvas::end(std::size_t start) {
  const std::size_t corners = (shapes_.size() - start) / 2;
  shapes_[start - 1] = static_cast<float>(corners);
}

void WorldCanvas::add_solids() {
  std::vector<pages::Solid> solids = page_.content().solids;
  pages::open_view(solids, camera_.eye());
  std::size_t faces = 0;
  for (const pages::Solid& solid : solids) faces += solid.mesh->faces.size() / 2;
  for (const std::size_t i : back_to_front(solids, seen_)) {
    add_solid(solids[i], faces <= most_outlined);
  }
}

void WorldCanvas::add_solid(const pages::Solid& solid, bool is_outlined) {
  const HalfEdgeMesh& mesh = *solid.mesh;
  const Vec3 eye = solid.pose.to_body(camera_.eye());
  faces_.clear();
  for (const Face& face : mesh.faces) faces_.push_back(face.plane.distance(eye) > 0);
  const bool is_in_front = project_vertices(solid);
  if (is_in_front && !is_on_canvas()) return;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (!faces_[face]) continue;
    if (is_in_front) {
      add_face(solid, face);
    } else {
      add_near_face(solid, face);
    }
  }
  const bool is_large = (most_ - least_).maxCoeff() > least_outlined;
  if (is_outlined && is_in_front && is_large) add_outline(mesh, solid.colour.w());
}

bool WorldCanvas::project_vertices(const pages::Solid& solid) {
  pixels_.clear();
  least_.setConstant(HUGE_VALF);
  most_.setConstant(-HUGE_VALF);
  for (const Vec3& vertex : solid.mesh->vertices) {
    const Vec3 point = solid.pose.to_world(vertex);
    if (!is_far_enough(point, seen_)) return false;
    pixels_.push_back(seen_.pixel(point));
    least_ = least_.cwiseMin(pixels_.back());
    most_ = most_.cwiseMax(pixels_.back());
  }
  return true;
}

bool WorldCanvas::is_on_canvas() const {
  return most_.x() > 0 && most_.y() > 0 && least_.x() < static_cast<Real>(canvas_.width) &&
         least_.y() < static_cast<Real>(canvas_.height);
}

void WorldCanvas::add_face(const pages::Solid& solid, Index face) {
  const HalfEdgeMesh& mesh = *solid.mesh;
  const Rgba colour = lit(solid.colour, solid.pose.rotate(mesh.face(face).plane.normal));
  const std::size_t start = begin(Polygon, colour, 0);
  for (const Index e : face_edges(mesh, face)) add(pixels_[mesh.origin(e)]);
  end(start);
}

void WorldCanvas::add_near_face(const pages::Solid& solid, Index face) {
  const HalfEdgeMesh& mesh = *solid.mesh;
  std::vector<Vec3> corners;
  for (const Index e : face_edges(mesh, face)) {
    corners.push_back(solid.pose.to_world(mesh.vertex(mesh.origin(e))));
  }
  const Rgba colour = lit(solid.colour, solid.pose.rotate(mesh.face(face).plane.normal));
  if (all_in_front(corners, seen_)) {
    add_polygon(colour, corners);
  } else if (corners.size() == 4) {  // a floor that reaches behind the camera
    for (const std::vector<Vec3>& cell : cells(corners)) {
      if (all_in_front(cell, seen_)) add_polygon(colour, cell);
    }
  }
}

void WorldCanvas::add_outline(const HalfEdgeMesh& mesh, float opacity) {
  const std::size_t start = begin(Segments, Rgba(0, 0, 0, 0.35F * opacity), 1);
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    const HalfEdge& edge = mesh.edge(e);
    if (!faces_[edge.face] && !faces_[mesh.edge(edge.twin).face]) continue;
    add(pixels_[mesh.origin(e)]);
    add(pixels_[edge.vertex]);
  }
  end(start);
}

void WorldCanvas::add_polygon(const Rgba& colour, const std::vector<Vec3>& corners) {
  const std::size_t start = begin(Polygon, colour, 0);
  for (const Vec3& corner : corners) add(seen_.pixel(corner));
  end(start);
}

void WorldCanvas::add_line(const drawing::Line& line) {
  if (!seen_.is_in_front(line.from) || !seen_.is_in_front(line.to)) return;
  const auto& [role, width, dashed, arrow] = line.stroke;
  const Kind kind = arrow ? (dashed ? DashedArrow : Arrow) : (dashed ? DashedLine : Line);
  const std::size_t start = begin(static_cast<float>(kind), pages::role_rgba(role), width);
  add(seen_.pixel(line.from));
  add(seen_.pixel(line.to));
  end(start);
}

void WorldCanvas::add_overlays() {
  const drawing::Drawing& drawing = page_.content().drawing;
  for (const drawing::Line& line : drawing.lines) add_line(line);
  for (const drawing::Point& point : drawing.points) {
    if (!seen_.is_in_front(point.position)) continue;
    const std::size_t start = begin(Dot, pages::role_rgba(point.role), point.radius);
    add(seen_.pixel(point.position));
    end(start);
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

void WorldCanvas::throw_box(const Vec2& pixel) { page_.throw_box(camera_.eye(), seen_.ray(pixel)); }

}  // namespace cs550::live
