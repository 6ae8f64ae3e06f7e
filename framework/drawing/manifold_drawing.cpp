#include "drawing/manifold_drawing.hpp"

#include <algorithm>

#include "drawing/mesh_drawing.hpp"
#include "drawing/text.hpp"

namespace cs550::drawing {
namespace {

/// Points of a plane, sorted by their angle about the centroid.
std::vector<Vec3> around(std::vector<Vec3> points, const Vec3& normal) {
  const Vec3 center = middle(points);
  const Vec3 u = any_perpendicular(normal);
  const Vec3 v = normal.cross(u);
  const auto angle = [&](const Vec3& p) {
    return std::atan2((p - center).dot(v), (p - center).dot(u));
  };
  std::sort(points.begin(), points.end(),
            [&](const Vec3& p, const Vec3& q) { return angle(p) < angle(q); });
  return points;
}

/// The polygon or line spanned by some points, or nothing.
void add_outline(Drawing& drawing, const std::vector<Vec3>& points, const Vec3& normal, Role role) {
  const bool all_finite = std::all_of(points.begin(), points.end(), is_finite);
  if (points.size() < 2 || !all_finite || !(normal.norm() > Real(0.5))) return;
  const std::vector<Vec3> outline = around(points, normal.normalized());
  add_closed_curve(drawing, outline, {role, 2});
  if (outline.size() >= 3) drawing.polygons.push_back({outline, role, Real(0.4)});
}

std::string of(const char* what, Index index, char body) {
  return std::string(what) + ' ' + std::to_string(index) + " of " + body;
}

}  // namespace

std::string feature_text(FeatureId feature) {
  using Kind = FeatureId::Kind;
  const Index a = feature.of_a();
  const Index b = feature.of_b();
  switch (feature.kind()) {
    case Kind::VertexOnFaceA:
    case Kind::CornerOfFaceB:
      return of("vertex", b, 'B') + " on " + of("face", a, 'A');
    case Kind::VertexOnFaceB:
    case Kind::CornerOfFaceA:
      return of("vertex", a, 'A') + " on " + of("face", b, 'B');
    case Kind::CrossingOnA:
    case Kind::CrossingOnB:
    case Kind::Edges:
      return of("edge", a, 'A') + " and " + of("edge", b, 'B');
    case Kind::None:
      break;
  }
  return "nothing";
}

Drawing draw_manifold(const Pose& a, const Pose& b, const Manifold& manifold, Role role,
                      Real length) {
  Drawing drawing;
  const int count = manifold.points.size();
  drawing.title = std::to_string(count) + (count == 1 ? " contact point" : " contact points");
  drawing.alt_text = "A manifold of " + std::to_string(count) + " points.";
  std::vector<Vec3> middles;
  for (const ContactPoint& point : manifold.points) {
    const Vec3 on_a = a.to_world(point.anchor_a);
    const Vec3 on_b = b.to_world(point.anchor_b);
    const Vec3 at = Real(0.5) * (on_a + on_b);
    middles.push_back(at);
    drawing.lines.push_back({on_a, on_b, {Role::Warning, Real(2.4)}});
    drawing.points.push_back({on_a, Role::BodyA, 3});
    drawing.points.push_back({on_b, Role::BodyB, 3});
    drawing.points.push_back({at, role, Real(5.5)});
    drawing.labels.push_back({at, length_text(static_cast<double>(point.separation)), Role::Text});
    add_arrow(drawing, at, length * manifold.normal, {Role::Axis, 2});
  }
  if (!middles.empty()) {
    add_arrow(drawing, middles.front(), Real(0.6) * length * manifold.tangent, {Role::Incident, 2},
              "u");
    drawing.labels.push_back({middles.front() + length * manifold.normal, "n", Role::Axis});
  }
  add_outline(drawing, middles, manifold.normal, role);
  return drawing;
}

Drawing draw_contact(const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                     Role role) {
  MeshStyle style;
  style.opacity = Real(0.3);
  style.edge_width = Real(1.3);
  Drawing drawing = draw_body(a, style);
  style.role = Role::BodyB;
  append(drawing, draw_body(b, style));
  drawing.labels.push_back({a.pose.position, "A", Role::BodyA});
  drawing.labels.push_back({b.pose.position, "B", Role::BodyB});
  const Real length = Real(0.45) * std::min(a.shape->radius, b.shape->radius);
  const Drawing points = draw_manifold(a.pose, b.pose, manifold, role, length);
  append(drawing, points);
  drawing.title = points.title;
  drawing.alt_text = "Bodies A and B in contact. " + points.alt_text;
  return drawing;
}

Drawing draw_reduction(std::span<const ContactPoint> points, std::span<const ContactPoint> kept,
                       const Vec3& normal, Role role) {
  Drawing drawing;
  drawing.title = std::to_string(kept.size()) + " of " + std::to_string(points.size()) + " points";
  drawing.alt_text = std::to_string(points.size()) +
                     " contact points with their separations, of which " +
                     std::to_string(kept.size()) + " are kept.";
  std::vector<Vec3> all;
  for (const ContactPoint& point : points) {
    all.push_back(point.anchor_a);
    drawing.points.push_back({point.anchor_a, Role::Axis, 3});
    drawing.labels.push_back(
        {point.anchor_a, length_text(static_cast<double>(point.separation)), Role::Axis});
  }
  if (normal.norm() > Real(0.5) && all.size() > 2) {
    add_closed_curve(drawing, around(all, normal.normalized()), {Role::Faint, Real(1.4)});
  }
  std::vector<Vec3> anchors;
  for (const ContactPoint& point : kept) {
    anchors.push_back(point.anchor_a);
    drawing.points.push_back({point.anchor_a, role, 6});
  }
  add_outline(drawing, anchors, normal, role);
  drawing.legend = {{"all points", {Role::Axis, 2}, LegendMark::Dot},
                    {"kept", {role, 2}, LegendMark::Patch}};
  return drawing;
}

}  // namespace cs550::drawing
