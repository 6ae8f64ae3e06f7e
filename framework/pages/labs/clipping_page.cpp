// Lab 5: the incident face after each clip, then the manifold.
#include "cs550/clipping.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/manifold_drawing.hpp"
#include "pages/base/units.hpp"
#include "pages/labs/body_pair.hpp"
#include "pages/labs/lab_page.hpp"

namespace cs550::pages {
namespace {

using drawing::Drawing;
using drawing::Role;

struct ClippingSettings {
  PairSettings pair = {Box, Prism, {Real(0.3), Real(-0.2), Real(1.05)}, {4, 3, 20}};
  int step = last_step;
  bool bodies = true;

  bool operator==(const ClippingSettings&) const = default;
};

void describe(ClippingSettings& settings, ControlVisitor& visit) {
  visit.section("Walk");
  visit.step({"step", "shown step", ""}, settings.step, 40);
  visit.toggle({"bodies", "bodies", ""}, settings.bodies);
  pages::describe(settings.pair, visit);
}

const Camera clipping_view = seen_from(Real(-1.2), Real(0.62));

/// The corners of a face, world frame.
std::vector<Vec3> corners_of(const PosedShape& body, Index face) {
  std::vector<Vec3> corners;
  for (const Index edge : face_edges(body.mesh(), face)) {
    corners.push_back(body.vertex(body.mesh().origin(edge)));
  }
  return corners;
}

/// The planes of the neighbours of a face, world frame.
std::vector<Plane> planes_around(const PosedShape& body, Index face) {
  std::vector<Plane> planes;
  for (const Index edge : face_edges(body.mesh(), face)) {
    planes.push_back(body.plane(body.mesh().edge(edge ^ 1).face));
  }
  return planes;
}

/// A polygon before clipping and after each plane.
std::vector<ClipPolygon> clipped_by_each(const std::vector<Vec3>& corners,
                                         const std::vector<Plane>& planes) {
  ClipPolygon polygon;
  for (const Vec3& corner : corners) polygon.push_back({corner, {}, {}});
  std::vector<ClipPolygon> polygons{polygon};
  for (const Plane& plane : planes) polygons.push_back(clip_polygon(polygons.back(), plane));
  return polygons;
}

std::string step_text(int step, int planes) {
  if (step == 0) return "the incident face";
  if (step > planes) return "the manifold";
  return "after plane " + std::to_string(step) + " of " + std::to_string(planes);
}

void add_bodies_to_legend(Drawing& drawing) {
  const drawing::LegendEntry bodies[] = {{"A", {Role::BodyA, 2}, drawing::LegendMark::Patch},
                                         {"B", {Role::BodyB, 2}, drawing::LegendMark::Patch}};
  drawing.legend.insert(drawing.legend.begin(), std::begin(bodies), std::end(bodies));
}

void show_manifold(const BodyPair& bodies, const SeparatingAxis& axis, Content& content) {
  const Manifold manifold = build_manifold(bodies.a, bodies.b, axis, HUGE_VALF);
  content.drawing =
      drawing::draw_manifold(bodies.a.pose, bodies.b.pose, manifold, Role::Highlight, Real(0.35));
  content.drawing.legend = {{"contact points", {Role::Highlight, 3}, drawing::LegendMark::Dot},
                            {"separation", {Role::Warning, 2}, {}},
                            {"normal n", {Role::Axis, 2, false, true}, {}},
                            {"tangent u", {Role::Incident, 2, false, true}, {}}};
  add_bodies_to_legend(content.drawing);
  content.facts.push_back({"points kept", std::to_string(manifold.points.size())});
  for (int i = 0; i < manifold.points.size(); ++i) {
    const ContactPoint& point = manifold.points[i];
    const std::string separation = quantity(static_cast<double>(point.separation), "m");
    content.facts.push_back({"point " + std::to_string(i + 1),
                             separation + ", " + drawing::feature_text(point.feature)});
  }
}

/// A face of one body meets the other body: the incident face is clipped.
/// @param reference_feature FaceA or FaceB: the body of the reference face
void show_faces(const BodyPair& bodies, const SeparatingAxis& axis, AxisFeature reference_feature,
                int shown, Content& content) {
  const bool on_b = reference_feature == AxisFeature::FaceB;
  const PosedShape& reference_body = on_b ? bodies.b : bodies.a;
  const PosedShape& incident_body = on_b ? bodies.a : bodies.b;
  const FaceQuery& query = on_b ? axis.face_b : axis.face_a;
  const Index reference_face = query.face;
  const Index incident_face =
      find_incident_face(incident_body, query.vertex, reference_body.plane(reference_face).normal);

  const std::vector<Vec3> reference = corners_of(reference_body, reference_face);
  const std::vector<Plane> planes = planes_around(reference_body, reference_face);
  const std::vector<ClipPolygon> polygons =
      clipped_by_each(corners_of(incident_body, incident_face), planes);
  const int plane_count = static_cast<int>(planes.size());

  content.step_count = plane_count + 2;
  const int step = shown_step(shown, content.step_count);
  const int clips = std::min(step, plane_count);
  content.drawing = drawing::draw_clipping(reference, planes, polygons, clips);
  add_bodies_to_legend(content.drawing);
  content.facts = {
      {"shown", step_text(step, plane_count)},
      {"reference", std::string(on_b ? "B" : "A") + ", face " + std::to_string(reference_face)},
      {"incident face", std::to_string(incident_face)},
      {"corners", std::to_string(polygons[clips].size())}};
  if (step > plane_count) show_manifold(bodies, axis, content);
}

void add_edge(Drawing& drawing, const PosedShape& body, Index edge, Role role) {
  const HalfEdgeMesh& mesh = body.mesh();
  if (edge < 0 || edge >= mesh.edge_count()) return;
  drawing.lines.push_back(
      {body.vertex(mesh.origin(edge)), body.vertex(mesh.edge(edge).vertex), {role, 4}});
}

/// Two edges meet in one point. Nothing is clipped.
void show_edges(const BodyPair& bodies, const SeparatingAxis& axis, Content& content) {
  const EdgeQuery& query = axis.edges;
  content.step_count = 1;
  content.facts = {{"shown", "the manifold: edges meet, nothing is clipped"},
                   {"edge of A", std::to_string(query.edge_a)},
                   {"edge of B", std::to_string(query.edge_b)}};
  show_manifold(bodies, axis, content);
  add_edge(content.drawing, bodies.a, query.edge_a, Role::BodyA);
  add_edge(content.drawing, bodies.b, query.edge_b, Role::BodyB);
}

/// Even if edges separate best, the manifold may be that of a face.
AxisFeature reference_of(const BodyPair& bodies, const SeparatingAxis& axis) {
  if (axis.feature != AxisFeature::Edges) return axis.feature;
  return build_manifold(bodies.a, bodies.b, axis, HUGE_VALF).reference;
}

Content show(const ClippingSettings& settings) {
  const BodyPair bodies(settings.pair);
  const SeparatingAxis axis = find_separating_axis(bodies.a, bodies.b, {}, HUGE_VALF);
  Content content;
  const AxisFeature reference = reference_of(bodies, axis);
  if (reference == AxisFeature::Edges) {
    show_edges(bodies, axis, content);
  } else {
    show_faces(bodies, axis, reference, settings.step, content);
  }
  if (settings.bodies) {
    content.solids.push_back(solid_of(bodies.a, Role::BodyA, 0.28F));
    content.solids.push_back(solid_of(bodies.b, Role::BodyB, 0.28F));
  }
  const std::array<PosedShape, 2> both{bodies.a, bodies.b};
  content.focus = closer(focus_on({}, both), Real(0.85), both, clipping_view);
  return content;
}

std::vector<Handle> handles(const ClippingSettings& settings) {
  return pages::handles(settings.pair);
}
void move_handle(ClippingSettings& settings, std::size_t handle, const Vec3& point) {
  pages::move_handle(settings.pair, handle, point);
}
void turn_handle(ClippingSettings& settings, std::size_t handle, const Vec3& rotation) {
  pages::turn_handle(settings.pair, handle, rotation);
}

}  // namespace

std::unique_ptr<Page> make_clipping_page(Isolation isolation) {
  LabPageParts<ClippingSettings> parts;
  parts.lab = 5;
  parts.story =
      "The incident face is clipped by the planes beside the reference face, one after the other. "
      "On a box these are its side planes. The last step shows the manifold: at most four points. "
      "Drag A or B by its middle to move it, and with the right button to turn it.";
  parts.first_view = clipping_view;
  parts.describe = describe;
  parts.show = show;
  parts.handles = handles;
  parts.move_handle = move_handle;
  parts.turn_handle = turn_handle;
  return std::make_unique<LabPage<ClippingSettings>>(parts, isolation);
}

}  // namespace cs550::pages
