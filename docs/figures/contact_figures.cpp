#include <fmt/format.h>

#include <algorithm>

#include "cs550/clipping.hpp"
#include "drawing/mesh_drawing.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

ClipPolygon polygon_of(const std::vector<Vec3>& corners) {
  ClipPolygon polygon;
  for (const Vec3& corner : corners) polygon.push_back({corner, {}, {}});
  return polygon;
}

std::vector<Vec3> corners_of(const ClipPolygon& polygon) {
  std::vector<Vec3> corners;
  for (const ClipVertex& vertex : polygon) corners.push_back(vertex.point);
  return corners;
}

Page manifold() {
  const ShapePtr lower = box({1, 1, Real(0.35)});
  const ShapePtr upper = box({Real(0.8), Real(0.6), Real(0.35)});
  const PosedShape a{lower.get(), {}};
  const PosedShape b{
      upper.get(),
      {Vec3(Real(0.5), Real(-0.25), Real(0.67)),
       rotation_exp(Vec3(0, 0, Real(0.5))) * rotation_exp(Vec3(Real(0.02), Real(0.015), 0))}};
  const SeparatingAxis axis = find_separating_axis(a, b, {}, Real(0.1));
  const Manifold found = build_manifold(a, b, axis, Real(0.1));

  Drawing sketch = drawing::draw_body(a, {Role::BodyA, Real(0.3)});
  drawing::append(sketch, drawing::draw_body(b, {Role::BodyB, Real(0.12)}));
  std::vector<Vec3> points;
  for (const ContactPoint& point : found.points)
    points.push_back(a.pose.to_world(point.anchor_a) + Vec3(0, 0, Real(0.01)));
  sketch.polygons.push_back({flat_hull(points), Role::Incident, Real(0.6)});
  for (const Vec3& point : points) {
    add_dot(sketch, point, Role::Got, "", 6);
    drawing::add_arrow(sketch, point, Real(0.35) * found.normal, {Role::Got, 2.2f});
  }
  sketch.title.clear();
  sketch.legend = {
      {"A: its top is the reference face", {Role::BodyA, 2}, drawing::LegendMark::Patch},
      {"B", {Role::BodyB, 2}, drawing::LegendMark::Patch},
      {"what clipping leaves of B's bottom face", {Role::Incident, 2}, drawing::LegendMark::Patch}};
  View view;
  view.toward_eye = Vec3(Real(1), Real(-2), Real(1.5));
  return page_of(sketch, view, {620, 400});
}

Page clip_steps() {
  const std::vector<Vec3> reference = {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
  const std::vector<Vec3> incident = regular_polygon(5, at(0.35, 0.25), 1.45, 0.3);
  ClipPolygon polygon = polygon_of(incident);
  std::vector<Drawing> sketches;
  std::vector<Vec3> before = incident;
  const auto show = [&](const std::string& title) {
    Drawing sketch;
    add_outline(sketch, incident, {Role::Faint, 1, true});
    add_outline(sketch, reference, {Role::BodyA, 2});
    const std::vector<Vec3> corners = corners_of(polygon);
    add_area(sketch, corners, Role::Incident, 0.5);
    for (const Vec3& corner : corners) {
      const bool is_new = std::find(before.begin(), before.end(), corner) == before.end();
      if (is_new) add_dot(sketch, corner, Role::Got, "", 4);
    }
    before = corners;
    sketch.title = title;
    sketches.push_back(sketch);
  };
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const Vec3 along = reference[(i + 1) % 4] - reference[i];
    const Vec3 outward = along.cross(Vec3::UnitZ()).normalized();
    polygon = clip_polygon(polygon, {outward, outward.dot(reference[i])});
    show("plane " + std::to_string(i + 1));
  }
  Page page = page_of(sketches, drawing::view_from_above(), {190, 190});
  page.framed_by_first = true;
  return page;
}

/// One edge of an outline, and what the clip emits of it. The side x ≤ 0 is kept.
void add_case(Drawing& sketch, const Vec3& place, const Vec3& a, const Vec3& b,
              const std::vector<Vec3>& emitted, const std::string& text) {
  const auto moved = [&](double x, double y) { return Vec3(place + at(x, y)); };
  sketch.polygons.push_back(
      {{moved(-1.2, -0.75), moved(0, -0.75), moved(0, 0.75), moved(-1.2, 0.75)},
       Role::Expected,
       Real(0.25)});
  add_line(sketch, moved(0, -0.75), moved(0, 0.75), {Role::Axis, 1.5f});
  add_line(sketch, place + a, place + b, {Role::Incident, 2.5f, false, true});
  for (const Vec3& point : emitted) add_dot(sketch, place + point, Role::Got, "", 6);
  sketch.labels.push_back({place + a, "A", Role::Text});
  sketch.labels.push_back({place + b, "B", Role::Text});
  sketch.labels.push_back({moved(0, -1.02), text, Role::Text});
}

Page clip_cases() {
  Drawing sketch;
  const Vec3 inside_low = at(-0.8, -0.45), inside_high = at(-0.7, 0.45),
             outside_low = at(0.8, -0.45), outside_high = at(0.7, 0.45);
  const Vec3 on = at(0, 0.3);
  const auto cut = [](const Vec3& a, const Vec3& b) {
    return Vec3(a + (a.x() / (a.x() - b.x())) * (b - a));
  };
  add_case(sketch, at(0, 0), inside_low, inside_high, {inside_high}, "front, front: B");
  add_case(sketch, at(3, 0), outside_low, inside_high, {cut(outside_low, inside_high), inside_high},
           "behind, front: I, B");
  add_case(sketch, at(6, 0), inside_low, outside_high, {cut(inside_low, outside_high)},
           "front, behind: I");
  add_case(sketch, at(0, -2.5), outside_low, outside_high, {}, "behind, behind: nothing");
  add_case(sketch, at(3, -2.5), outside_low, on, {on}, "B on the plane: B, once");
  add_case(sketch, at(6, -2.5), on, outside_low, {}, "A on the plane: nothing more");
  sketch.legend = {{"side that is kept", {Role::Expected, 2}, drawing::LegendMark::Patch},
                   {"emitted", {Role::Got, 4}, drawing::LegendMark::Dot}};
  return page_of(sketch, drawing::view_from_above(), {680, 380});
}

double area_of(const std::vector<Vec3>& corners) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    doubled +=
        static_cast<double>((corners[i] - corners[0]).cross(corners[i + 1] - corners[0]).z());
  }
  return doubled / 2;
}

/// The deepest point, the farthest from it, and one extreme on either side of the line between them.
std::vector<Vec3> one_on_either_side(const std::vector<Vec3>& points) {
  const Vec3& first = points[0];
  const auto farther = [&](const Vec3& p, const Vec3& q) {
    return (p - first).norm() < (q - first).norm();
  };
  const Vec3 second = *std::max_element(points.begin(), points.end(), farther);
  const auto side = [&](const Vec3& p) { return (second - first).cross(p - first).z(); };
  const auto less = [&](const Vec3& p, const Vec3& q) { return side(p) < side(q); };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
  std::vector<Vec3> kept = {first, second};
  if (side(*low) < Real(-1e-4)) kept.push_back(*low);
  if (side(*high) > Real(1e-4)) kept.push_back(*high);
  return flat_hull(kept);
}

Page reduction() {
  // The rim of a half disc; the first point is the deepest, at one end of the straight side.
  std::vector<Vec3> rim;
  for (int i = 0; i <= 9; ++i) rim.push_back(at(std::cos(M_PI * i / 9), std::sin(M_PI * i / 9)));
  std::vector<ContactPoint> points;
  for (const Vec3& corner : rim) {
    ContactPoint point;
    point.anchor_a = corner;
    point.separation = points.empty() ? Real(-0.02) : Real(-0.01);
    points.push_back(point);
  }
  std::vector<Vec3> kept;
  for (const ContactPoint& point : reduce_manifold(points, Vec3::UnitZ(), 0))
    kept.push_back(point.anchor_a);

  const auto panel = [&](const std::vector<Vec3>& corners, Role role, const std::string& name) {
    Drawing sketch;
    add_outline(sketch, rim, {Role::Faint, 1});
    add_area(sketch, corners, role, 0.4);
    for (const Vec3& point : rim) add_dot(sketch, point, Role::Faint, "", 4);
    for (const Vec3& corner : corners) add_dot(sketch, corner, role, "", 6);
    sketch.labels.push_back({rim[0], "deepest", Role::Text});
    sketch.title =
        fmt::format("{}: {:.0f} % of the area", name, 100 * area_of(corners) / area_of(rim));
    return sketch;
  };
  return page_of({panel(flat_hull(kept), Role::BodyA, "four rules"),
                  panel(one_on_either_side(rim), Role::Got, "one on either side")},
                 drawing::view_from_above(), {330, 230});
}

Page clipped_depth() {
  Drawing sketch;
  const std::vector<Vec3> platform = {at(-2.6, -1.3), at(1, -1.3), at(1, 0), at(-2.6, 0)};
  const Vec3 deepest = at(1.42, -0.5);
  const std::vector<Vec3> tilted = {deepest, at(2.6, 0.7), at(1.1, 2.2), at(-0.08, 1.0)};
  add_area(sketch, platform, Role::BodyA, 0.35);
  add_area(sketch, tilted, Role::BodyB, 0.3);
  add_line(sketch, at(1, -1.7), at(1, 1.4), {Role::Axis, 1.2f, true}, "");
  sketch.labels.push_back({at(1, 1.5), "side plane", Role::Axis});
  add_line(sketch, at(1, 0), at(2.9, 0), {Role::Axis, 1.2f, true}, "");
  sketch.labels.push_back({at(2.9, 0), "reference plane", Role::Axis});
  const Vec3 clipped = at(1, -0.08);
  add_line(sketch, at(1.42, 0), deepest, {Role::BodyA, 2.5f});
  sketch.labels.push_back({at(1.95, -0.55), "face query", Role::BodyA});
  add_dot(sketch, deepest, Role::BodyA, "", 6);
  add_dot(sketch, clipped, Role::Got, "", 6);
  sketch.labels.push_back({at(0, -0.35), "what clipping leaves", Role::Got});
  return page_of(sketch, drawing::view_from_above(), {600, 380});
}

}  // namespace

std::vector<Figure> contact_figures() {
  return {{"manifold", manifold},
          {"clip_steps", clip_steps},
          {"clip_cases", clip_cases},
          {"reduction", reduction},
          {"clipped_depth", clipped_depth}};
}

}  // namespace cs550::book
