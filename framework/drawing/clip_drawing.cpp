#include "drawing/clip_drawing.hpp"

#include <algorithm>

namespace cs550::drawing {
namespace {

struct Piece {
  Vec3 from, to;
};

/// The part of a plane that is drawn: at the height of a polygon, and as long as it.
Piece passing_by(const Plane& plane, std::span<const Vec3> near) {
  const Vec3 center = middle(near);
  const Vec3 foot = center - plane.distance(center) * plane.normal;
  Vec3 along = polygon_normal(near).cross(plane.normal);
  if (!(along.norm() > Real(1e-6))) along = any_perpendicular(plane.normal);
  along.normalize();
  Real reach = 0;
  for (const Vec3& point : near) reach = std::max(reach, std::abs(along.dot(point - foot)));
  reach = Real(1.15) * std::max(reach, Real(1e-6));
  return {foot - reach * along, foot + reach * along};
}

}  // namespace

std::vector<Vec3> corners(const ClipPolygon& polygon) {
  std::vector<Vec3> result;
  for (const ClipVertex& corner : polygon) result.push_back(corner.point);
  return result;
}

Vec3 polygon_normal(std::span<const Vec3> corners) {
  Vec3 normal = Vec3::Zero();
  const Vec3 center = middle(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normal += (corners[i] - center).cross(corners[(i + 1) % corners.size()] - center);
  }
  return normal.norm() > 0 && is_finite(normal) ? Vec3(normal.normalized()) : Vec3::UnitZ();
}

Drawing draw_clip_polygon(const ClipPolygon& polygon, Role role, Real opacity) {
  Drawing drawing;
  drawing.title = "Polygon of " + std::to_string(polygon.size()) + " corners";
  drawing.alt_text = "A polygon of " + std::to_string(polygon.size()) + " corners.";
  const std::vector<Vec3> points = corners(polygon);
  add_closed_curve(drawing, points, {role, Real(2.4)});
  for (std::size_t i = 0; i < points.size(); ++i) {
    drawing.points.push_back({points[i], role, Real(4.5)});
    drawing.labels.push_back({points[i], std::to_string(i), Role::Text});
  }
  if (points.size() >= 3) drawing.polygons.push_back({points, role, opacity});
  return drawing;
}

Drawing draw_clip_plane(const Plane& plane, std::span<const Vec3> near, const std::string& name) {
  Drawing drawing;
  if (near.empty()) return drawing;
  const Piece ends = passing_by(plane, near);
  drawing.lines.push_back({ends.from, ends.to, {.role = Role::Axis, .width = 2, .dashed = true}});
  add_arrow(drawing, Real(0.5) * (ends.from + ends.to),
            Real(0.09) * (ends.to - ends.from).norm() * plane.normal, {Role::Axis, 2}, name);
  return drawing;
}

Drawing draw_clip(const ClipPolygon& before, const Plane& plane, const ClipPolygon& after,
                  Role role) {
  Drawing drawing;
  const std::vector<Vec3> points = corners(before);
  if (points.size() >= 3) drawing.polygons.push_back({points, Role::Faint, Real(0.35)});
  add_closed_curve(drawing, points, {Role::Faint, 2});
  append(drawing, draw_clip_plane(plane, points, "cut away"));
  append(drawing, draw_clip_polygon(after, role));
  drawing.title = std::to_string(after.size()) + " corners are left";
  drawing.alt_text = "A polygon of " + std::to_string(before.size()) +
                     " corners, a plane, and the " + std::to_string(after.size()) +
                     " corners that the plane leaves of it.";
  drawing.legend = {{"before", {Role::Faint, 2}, LegendMark::Patch},
                    {"after", {role, 2}, LegendMark::Patch},
                    {"plane", {.role = Role::Axis, .width = 2, .dashed = true}, LegendMark::Line}};
  return drawing;
}

Drawing draw_clipping(std::span<const Vec3> reference, std::span<const Plane> planes,
                      std::span<const ClipPolygon> polygons, int steps) {
  Drawing drawing;
  if (polygons.empty()) return drawing;
  const auto last = std::min(static_cast<std::size_t>(std::max(steps, 0)),
                             std::min(planes.size(), polygons.size() - 1));
  drawing.title = last == 0 ? "Incident face" : "After plane " + std::to_string(last);
  drawing.alt_text = "The reference face and the incident face, of which " + std::to_string(last) +
                     " planes leave " + std::to_string(polygons[last].size()) + " corners.";
  drawing.polygons.push_back({{reference.begin(), reference.end()}, Role::Reference, Real(0.3)});
  add_closed_curve(drawing, reference, {Role::Reference, 2});
  add_closed_curve(drawing, corners(polygons.front()),
                   {.role = Role::Incident, .width = Real(1.4), .dashed = true});
  if (last > 0) append(drawing, draw_clip_plane(planes[last - 1], reference, "cut away"));
  append(drawing, draw_clip_polygon(polygons[last], Role::Incident, Real(0.6)));
  drawing.legend = {{"reference face", {Role::Reference, 2}, LegendMark::Patch},
                    {"incident face",
                     {.role = Role::Incident, .width = Real(1.4), .dashed = true},
                     LegendMark::Line},
                    {"what is left", {Role::Incident, 2}, LegendMark::Patch}};
  if (last > 0) {
    drawing.legend.push_back({"plane", {.role = Role::Axis, .width = 2, .dashed = true}});
  }
  return drawing;
}

}  // namespace cs550::drawing
