// Lab 5: the incident face is clipped, plane by plane, and few points are kept.
#include "cs550/clipping.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/manifold_drawing.hpp"
#include "viewer/pages/body_pair.hpp"
#include "viewer/pages/lab_page.hpp"
#include "viewer/units.hpp"

namespace cs550::viewer {
namespace {

using drawing::Drawing;
using drawing::Role;

struct ClippingSettings {
  PairSettings pair = {Box, Prism, {Real(0.3), Real(-0.2), Real(1.05)}, {4, 3, 20}};
  int step = -1;
  bool bodies = true;

  bool operator==(const ClippingSettings&) const = default;
};

void describe(ClippingSettings& settings, ControlVisitor& visit) {
  visit.section("Walk");
  visit.whole({"step", "shown step", ""}, settings.step, -1, 40);
  visit.toggle({"bodies", "bodies", ""}, settings.bodies);
  viewer::describe(settings.pair, visit);
}

/// The two faces that meet, and what each side plane of the reference face leaves.
struct Clipping {
  const PosedShape* reference_body = nullptr;
  const PosedShape* incident_body = nullptr;
  Index reference_face = no_index;
  Index incident_face = no_index;
  std::vector<Vec3> reference;        // corners, world
  std::vector<Plane> planes;          // sides, world
  std::vector<ClipPolygon> polygons;  // incident, then after each plane; world
};

Clipping clip(const BodyPair& bodies, const SeparatingAxis& axis) {
  const bool on_a =
      axis.face_a &&
      (!axis.face_b || axis.feature == AxisFeature::FaceA ||
       (axis.feature == AxisFeature::Edges && axis.face_a.separation >= axis.face_b.separation));
  Clipping clipping;
  clipping.reference_body = on_a ? &bodies.a : &bodies.b;
  clipping.incident_body = on_a ? &bodies.b : &bodies.a;
  clipping.reference_face = on_a ? axis.face_a.face : axis.face_b.face;
  const PosedShape& body = *clipping.reference_body;
  const Vec3 normal = body.plane(clipping.reference_face).normal;
  clipping.incident_face = find_incident_face(*clipping.incident_body, normal);

  ClipPolygon polygon;
  const HalfEdgeMesh& incident = clipping.incident_body->mesh();
  for (const Index e : face_edges(incident, clipping.incident_face)) {
    polygon.push_back({clipping.incident_body->vertex(incident.edge(e).vertex),
                       {ClipEdge::Source::Incident, e},
                       {ClipEdge::Source::Incident, incident.edge(e).next}});
  }
  clipping.polygons.push_back(polygon);
  for (const Index e : face_edges(body.mesh(), clipping.reference_face)) {
    const Vec3 corner = body.vertex(body.mesh().origin(e));
    const Vec3 outward = body.pose.rotate(body.mesh().edge_vector(e)).cross(normal).normalized();
    const Plane side{outward, outward.dot(corner)};
    clipping.reference.push_back(corner);
    clipping.planes.push_back(side);
    polygon = clip_polygon(polygon, side, {ClipEdge::Source::Reference, e});
    clipping.polygons.push_back(polygon);
  }
  return clipping;
}

std::string step_text(int step, int planes) {
  if (step == 0) return "the incident face as it is";
  if (step <= planes)
    return "after plane " + std::to_string(step) + " of " + std::to_string(planes);
  return "the points that are kept";
}

Content show(const ClippingSettings& settings) {
  const BodyPair bodies(settings.pair);
  const SeparatingAxis axis = find_separating_axis(bodies.a, bodies.b, {}, HUGE_VALF);
  const Clipping clipping = clip(bodies, axis);
  const int planes = static_cast<int>(clipping.planes.size());

  Content content;
  content.step_count = planes + 2;
  const int step = shown_step(settings.step, content.step_count);
  content.drawing = drawing::draw_clipping(clipping.reference, clipping.planes, clipping.polygons,
                                           std::min(step, planes));
  content.facts = {
      {"shown", step_text(step, planes)},
      {"reference", std::string(clipping.reference_body == &bodies.a ? "A" : "B") + ", face " +
                        std::to_string(clipping.reference_face)},
      {"incident face", std::to_string(clipping.incident_face)},
      {"corners",
       std::to_string(clipping.polygons[static_cast<std::size_t>(std::min(step, planes))].size())}};
  if (step > planes) {
    const Manifold manifold = build_manifold(bodies.a, bodies.b, axis, HUGE_VALF);
    content.drawing =
        drawing::draw_manifold(bodies.a.pose, bodies.b.pose, manifold, Role::Highlight, Real(0.35));
    content.facts.push_back({"points kept", std::to_string(manifold.points.size())});
    for (const ContactPoint& point : manifold.points) {
      content.facts.push_back({"separation", quantity(static_cast<double>(point.separation), "m")});
    }
  }
  if (settings.bodies) {
    content.solids.push_back(solid_of(bodies.a, Role::BodyA, 0.28F));
    content.solids.push_back(solid_of(bodies.b, Role::BodyB, 0.28F));
  }
  const std::array<PosedShape, 2> both{bodies.a, bodies.b};
  content.focus = focus_on({}, both);
  content.focus.radius *= Real(0.85);
  return content;
}

Vec3 handle(const ClippingSettings& settings) { return settings.pair.position; }
void move_handle(ClippingSettings& settings, const Vec3& point) { settings.pair.position = point; }

}  // namespace

std::unique_ptr<Page> make_clipping_page(Isolation isolation) {
  LabPageParts<ClippingSettings> parts;
  parts.lab = 5;
  parts.story =
      "The incident face is clipped by the side planes of the reference face, one after the other. "
      "Of "
      "what is left, at most four points support the body.";
  parts.first_view = seen_from(Real(-1.2), Real(0.62));
  parts.describe = describe;
  parts.show = show;
  parts.handle = handle;
  parts.move_handle = move_handle;
  return std::make_unique<LabPage<ClippingSettings>>(parts, isolation);
}

}  // namespace cs550::viewer
