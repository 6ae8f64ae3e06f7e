#include "drawing/gauss_map_drawing.hpp"

#include <algorithm>

#include "drawing/mesh_drawing.hpp"
#include "drawing/text.hpp"

namespace cs550::drawing {
namespace {

constexpr Real arc_width = 2;
constexpr Real arc_step = pi / 60;

bool has_edge(const PosedShape& body, Index e) { return 0 <= e && e < body.mesh().edge_count(); }
bool has_face(const PosedShape& body, Index f) { return 0 <= f && f < body.mesh().face_count(); }
bool has_vertex(const PosedShape& body, Index v) {
  return 0 <= v && v < body.mesh().vertex_count();
}

GaussArc arc_of(const PosedShape& body, Index edge, bool negated) {
  const HalfEdge& half_edge = body.mesh().edge(edge);
  const Real sign = negated ? Real(-1) : Real(1);
  return {edge, sign * body.plane(half_edge.face).normal,
          sign * body.plane(body.mesh().edge(half_edge.twin).face).normal};
}

/// The intersection of the great circles of two arcs, on the arcs' side of the sphere. Zero if they
/// do not intersect in a point.
Vec3 crossing_point(const GaussArc& a, const GaussArc& b) {
  const Vec3 x = a.from.cross(a.to).cross(b.from.cross(b.to));
  if (!(x.norm() > Real(1e-9))) return Vec3::Zero();
  const Vec3 unit = x.normalized();
  return unit.dot(a.from + a.to + b.from + b.to) < 0 ? Vec3(-unit) : unit;
}

void add_arc(Drawing& drawing, const GaussArc& arc, const Stroke& stroke) {
  if (!is_finite(arc.from) || !is_finite(arc.to)) return;
  add_curve(drawing, arc_points(arc.from, arc.to), stroke);
}

Line edge_line(const PosedShape& body, Index e, const Stroke& stroke) {
  return {body.vertex(body.mesh().origin(e)), body.vertex(body.mesh().edge(e).vertex), stroke};
}

/// Draws a face of one body and the deepest vertex of the other behind it.
/// @return where the axis can begin
Vec3 add_face_feature(Drawing& drawing, const PosedShape& owner, const PosedShape& other,
                      const FaceQuery& query, Role role) {
  if (!has_face(owner, query.face)) {
    drawing.notes.push_back("Face " + std::to_string(query.face) + " does not exist.");
    return owner.pose.position;
  }
  Polygon face = face_polygon(owner.mesh(), query.face, role, Real(0.85), Real(1e-3));
  for (Vec3& corner : face.corners) corner = owner.pose.to_world(corner);
  drawing.polygons.push_back(face);
  if (!has_vertex(other, query.vertex)) {
    drawing.notes.push_back("Vertex " + std::to_string(query.vertex) + " does not exist.");
    return middle(face.corners);
  }
  const Vec3 vertex = other.vertex(query.vertex);
  const Plane plane = owner.plane(query.face);
  Vec3 foot = vertex - plane.distance(vertex) * plane.normal;
  drawing.points.push_back({vertex, role, 5});
  drawing.labels.push_back({vertex, "v" + std::to_string(query.vertex), Role::Text});
  drawing.lines.push_back({foot, vertex, {.role = Role::Text, .width = Real(1.6), .dashed = true}});
  return foot;
}

/// @return where the axis can begin
Vec3 add_edge_feature(Drawing& drawing, const PosedShape& a, const PosedShape& b,
                      const EdgeQuery& query, Role role) {
  Vec3 start = a.pose.position;
  const Stroke stroke = {role, 4};
  if (has_edge(a, query.edge_a)) {
    drawing.lines.push_back(edge_line(a, query.edge_a, stroke));
    start = Real(0.5) * (drawing.lines.back().from + drawing.lines.back().to);
  } else {
    drawing.notes.push_back("A has no edge " + std::to_string(query.edge_a) + ".");
  }
  if (has_edge(b, query.edge_b)) {
    drawing.lines.push_back(edge_line(b, query.edge_b, stroke));
  } else {
    drawing.notes.push_back("B has no edge " + std::to_string(query.edge_b) + ".");
  }
  return start;
}

}  // namespace

std::vector<GaussArc> gauss_arcs(const PosedShape& body, bool negated) {
  std::vector<GaussArc> arcs;
  for (Index e = 0; e < body.mesh().edge_count(); e += 2) arcs.push_back(arc_of(body, e, negated));
  return arcs;
}

std::vector<Vec3> arc_points(const Vec3& from, const Vec3& to) {
  const Real angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const int pieces = std::max(1, static_cast<int>(std::ceil(angle / arc_step)));
  std::vector<Vec3> points;
  for (int i = 0; i <= pieces; ++i) {
    const Real t = static_cast<Real>(i) / static_cast<Real>(pieces);
    // Shoemake's slerp, normalised because sin(angle) may be tiny.
    const Vec3 point = std::sin((1 - t) * angle) * from + std::sin(t * angle) * to;
    points.push_back(point.norm() > 0 ? Vec3(point.normalized()) : from);
  }
  return points;
}

Drawing draw_unit_sphere() {
  Drawing drawing;
  drawing.balls.push_back({Vec3::Zero(), 1, Role::Faint, Real(0.82)});
  return drawing;
}

Drawing draw_gauss_map(const PosedShape& body, Role role, bool negated) {
  Drawing drawing;
  const std::string name = negated ? "the negated normals" : "the normals";
  drawing.title = negated ? "Gauss map, negated" : "Gauss map";
  drawing.alt_text = "On the unit sphere " + name + " of " +
                     std::to_string(body.mesh().face_count()) + " faces as points and " +
                     std::to_string(body.mesh().edge_count() / 2) + " edges as arcs.";
  const std::vector<GaussArc> arcs = gauss_arcs(body, negated);
  for (const GaussArc& arc : arcs) add_arc(drawing, arc, {role, arc_width});
  for (Index f = 0; f < body.mesh().face_count(); ++f) {
    const Vec3 normal = body.plane(f).normal;
    drawing.points.push_back({negated ? Vec3(-normal) : normal, role, 4});
  }
  return drawing;
}

Drawing draw_arc_pair(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Drawing drawing = draw_unit_sphere();
  drawing.title = "Two arcs on the Gauss map";
  drawing.alt_text = "The arc from a to b of A and the arc from c to d of −B on the unit sphere.";
  add_arc(drawing, {no_index, a, b}, {Role::BodyA, Real(2.6)});
  add_arc(drawing, {no_index, c, d}, {Role::BodyB, Real(2.6)});
  const std::pair<const Vec3&, const char*> ends[] = {{a, "a"}, {b, "b"}, {c, "c"}, {d, "d"}};
  for (int i = 0; i < 4; ++i) {
    drawing.points.push_back({ends[i].first, i < 2 ? Role::BodyA : Role::BodyB, 5});
    drawing.labels.push_back({ends[i].first, ends[i].second, Role::Text});
  }
  drawing.legend = {{"arc of A: a to b", {Role::BodyA, Real(2.6)}, LegendMark::Line},
                    {"arc of −B: c to d", {Role::BodyB, Real(2.6)}, LegendMark::Line}};
  return drawing;
}

Drawing draw_gauss_maps(const PosedShape& a, const PosedShape& b, std::span<const EdgePair> pairs,
                        const SeparatingAxis& axis) {
  Drawing drawing = draw_unit_sphere();
  append(drawing, draw_gauss_map(a, Role::BodyA));
  append(drawing, draw_gauss_map(b, Role::BodyB, true));
  drawing.title = "Gauss maps of A and −B";
  drawing.alt_text = "The Gauss maps of A and of negated B on one sphere; " +
                     std::to_string(pairs.size()) + " pairs of arcs cross.";
  for (const EdgePair& pair : pairs) {
    if (!has_edge(a, pair.edge_a) || !has_edge(b, pair.edge_b)) continue;
    const Vec3 at = crossing_point(arc_of(a, pair.edge_a, false), arc_of(b, pair.edge_b, true));
    if (at.norm() > 0) drawing.points.push_back({at, Role::Highlight, 5});
  }
  if (axis.feature == AxisFeature::Edges && has_edge(a, axis.edges.edge_a) &&
      has_edge(b, axis.edges.edge_b)) {
    add_arc(drawing, arc_of(a, axis.edges.edge_a, false), {Role::Axis, 3});
    add_arc(drawing, arc_of(b, axis.edges.edge_b, true), {Role::Axis, 3});
  }
  if (axis.feature != AxisFeature::None) {
    add_arrow(drawing, axis.axis, Real(0.45) * axis.axis, {Role::Axis, 3}, "axis");
  }
  drawing.legend = {
      {"normals and arcs of A", {Role::BodyA, 2}, LegendMark::Line},
      {"normals and arcs of −B", {Role::BodyB, 2}, LegendMark::Line},
  };
  if (!pairs.empty()) {
    drawing.legend.push_back({"crossings", {Role::Highlight, 3}, LegendMark::Dot});
  }
  if (axis.feature == AxisFeature::Edges) {
    drawing.legend.push_back({"edges of the axis", {Role::Axis, 3}});
  }
  return drawing;
}

std::string feature_text(const SeparatingAxis& axis) {
  switch (axis.feature) {
    case AxisFeature::FaceA:
      return "face " + std::to_string(axis.face_a.face) + " of A";
    case AxisFeature::FaceB:
      return "face " + std::to_string(axis.face_b.face) + " of B";
    case AxisFeature::Edges:
      return "edges " + std::to_string(axis.edges.edge_a) + " of A and " +
             std::to_string(axis.edges.edge_b) + " of B";
    case AxisFeature::None:
      break;
  }
  return "no axis";
}

Drawing draw_axis(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis, Role role) {
  MeshStyle style;
  style.opacity = Real(0.45);
  Drawing drawing = draw_body(a, style);
  style.role = Role::BodyB;
  append(drawing, draw_body(b, style));
  drawing.labels.push_back({a.pose.position, "A", Role::BodyA});
  drawing.labels.push_back({b.pose.position, "B", Role::BodyB});
  drawing.title = "Axis of " + feature_text(axis);
  drawing.alt_text = "Bodies A and B, and the axis of " + feature_text(axis) + ": separation " +
                     length_text(static_cast<double>(axis.separation)) + ".";
  drawing.notes.push_back("Separation " + length_text(static_cast<double>(axis.separation)) + '.');

  Vec3 from = Real(0.5) * (a.pose.position + b.pose.position);
  switch (axis.feature) {
    case AxisFeature::FaceA:
      from = add_face_feature(drawing, a, b, axis.face_a, role);
      break;
    case AxisFeature::FaceB:
      from = add_face_feature(drawing, b, a, axis.face_b, role);
      break;
    case AxisFeature::Edges:
      from = add_edge_feature(drawing, a, b, axis.edges, role);
      break;
    case AxisFeature::None:
      break;
  }
  const Real length = Real(0.8) * std::max(a.shape->radius, b.shape->radius);
  add_arrow(drawing, from, length * axis.axis, {role, 3}, "axis");
  return drawing;
}

}  // namespace cs550::drawing
