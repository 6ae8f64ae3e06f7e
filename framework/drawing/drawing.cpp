#include "drawing/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace cs550::drawing {
namespace {

template <class Element>
void append_all(std::vector<Element>& to, const std::vector<Element>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Calls a visitor with every position of a drawing.
template <class AnyDrawing, class Visit>
void for_each_position(AnyDrawing& drawing, const Visit& visit) {
  for (auto& point : drawing.points) visit(point.position);
  for (auto& line : drawing.lines) {
    visit(line.from);
    visit(line.to);
  }
  for (auto& polygon : drawing.polygons) {
    for (auto& corner : polygon.corners) visit(corner);
  }
  for (auto& ball : drawing.balls) visit(ball.center);
  for (auto& label : drawing.labels) visit(label.position);
}

/// Removes the items that do not satisfy a condition. @return how many were removed
template <class Element, class Condition>
int keep_if(std::vector<Element>& elements, const Condition& condition) {
  return static_cast<int>(
      std::erase_if(elements, [&](const Element& element) { return !condition(element); }));
}

}  // namespace

void append(Drawing& drawing, const Drawing& other) {
  append_all(drawing.points, other.points);
  append_all(drawing.lines, other.lines);
  append_all(drawing.polygons, other.polygons);
  append_all(drawing.balls, other.balls);
  append_all(drawing.labels, other.labels);
  append_all(drawing.legend, other.legend);
  append_all(drawing.notes, other.notes);
}

Drawing transformed(Drawing drawing, const Pose& pose) {
  for_each_position(drawing, [&](Vec3& position) { position = pose.to_world(position); });
  return drawing;
}

void add_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke) {
  Stroke piece = stroke;
  piece.dashed = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (stroke.dashed && i % 2 == 0) continue;
    piece.arrow = stroke.arrow && i + 1 == points.size();
    drawing.lines.push_back({points[i - 1], points[i], piece});
  }
}

void add_closed_curve(Drawing& drawing, std::span<const Vec3> points, const Stroke& stroke) {
  if (points.empty()) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    drawing.lines.push_back({points[i], points[(i + 1) % points.size()], stroke});
  }
}

void add_arrow(Drawing& drawing, const Vec3& from, const Vec3& vector, const Stroke& stroke,
               const std::string& label) {
  Stroke with_head = stroke;
  with_head.arrow = true;
  drawing.lines.push_back({from, from + vector, with_head});
  if (!label.empty()) drawing.labels.push_back({from + vector, label, stroke.role});
}

Bounds bounds(const Drawing& drawing) {
  Bounds result;
  for_each_position(drawing, [&](const Vec3& position) {
    if (is_finite(position)) result.include(position);
  });
  for (const Ball& ball : drawing.balls) {
    if (!is_finite(ball.center) || !std::isfinite(ball.radius)) continue;
    const Vec3 half = Vec3::Constant(ball.radius);
    result.include(ball.center - half);
    result.include(ball.center + half);
  }
  return result;
}

Bounds bounds(std::span<const Drawing> drawings) {
  Bounds result;
  for (const Drawing& drawing : drawings) result.include(bounds(drawing));
  return result;
}

Drawing finite_part(const Drawing& drawing) {
  Drawing result = drawing;
  const int left_out =
      keep_if(result.points, [](const Point& p) { return is_finite(p.position); }) +
      keep_if(result.lines,
              [](const Line& line) { return is_finite(line.from) && is_finite(line.to); }) +
      keep_if(result.polygons,
              [](const Polygon& polygon) {
                return std::all_of(polygon.corners.begin(), polygon.corners.end(), is_finite);
              }) +
      keep_if(result.balls,
              [](const Ball& b) { return is_finite(b.center) && std::isfinite(b.radius); }) +
      keep_if(result.labels, [](const Label& label) { return is_finite(label.position); });
  if (left_out > 0) {
    result.notes.push_back(std::to_string(left_out) +
                           (left_out == 1 ? " element has" : " elements have") +
                           " coordinates that are not finite: left out.");
  }
  return result;
}

bool is_finite(const Vec3& position) {
  return position.allFinite() && std::isfinite(position.squaredNorm());
}

Vec3 middle(std::span<const Vec3> positions) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& position : positions) sum += position;
  return sum / static_cast<Real>(std::max<std::size_t>(positions.size(), 1));
}

}  // namespace cs550::drawing
