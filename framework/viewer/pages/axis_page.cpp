// Lab 4: two bodies, their Gauss maps, and every axis that is tried.
#include <algorithm>

#include "cs550/separating_axis.hpp"
#include "drawing/gauss_map_drawing.hpp"
#include "drawing/minkowski_drawing.hpp"
#include "viewer/pages/body_pair.hpp"
#include "viewer/pages/lab_page.hpp"
#include "viewer/units.hpp"

namespace cs550::viewer {
namespace {

using drawing::Drawing;
using drawing::EdgePair;
using drawing::GaussArc;
using drawing::Role;

struct AxisSettings {
  PairSettings pair = {Box, Box, {Real(0.35), Real(-0.62), Real(0.98)}, {38, 24, 40}};
  bool gauss_maps = true;
  bool minkowski = false;
  int step = 0;

  bool operator==(const AxisSettings&) const = default;
};

void describe(AxisSettings& settings, ControlVisitor& visit) {
  viewer::describe(settings.pair, visit);
  visit.section("Show");
  visit.toggle({"gauss_maps", "Gauss maps of A and −B", ""}, settings.gauss_maps);
  visit.toggle({"minkowski", "Minkowski difference", ""}, settings.minkowski);
}

/// The pairs of edges whose arcs cross.
std::vector<EdgePair> crossing_pairs(const PosedShape& a, const PosedShape& b) {
  const std::vector<GaussArc> arcs_a = drawing::gauss_arcs(a);
  const std::vector<GaussArc> arcs_b = drawing::gauss_arcs(b, true);
  std::vector<EdgePair> pairs;
  for (const GaussArc& arc_a : arcs_a) {
    for (const GaussArc& arc_b : arcs_b) {
      if (is_minkowski_face(arc_a.from, arc_a.to, arc_b.from, arc_b.to)) {
        pairs.push_back({arc_a.edge, arc_b.edge});
      }
    }
  }
  return pairs;
}

/// The signed distance of B's deepest vertex from each face of A.
std::vector<Real> face_separations(const PosedShape& a, const PosedShape& b) {
  std::vector<Real> separations;
  for (Index face = 0; face < a.mesh().face_count(); ++face) {
    Real deepest = HUGE_VALF;
    for (Index vertex = 0; vertex < b.mesh().vertex_count(); ++vertex) {
      deepest = std::min(deepest, a.plane(face).distance(b.vertex(vertex)));
    }
    separations.push_back(deepest);
  }
  return separations;
}

std::vector<Real> edge_separations(const PosedShape& a, const PosedShape& b,
                                   std::span<const EdgePair> pairs) {
  std::vector<Real> separations;
  for (const EdgePair& pair : pairs) {
    const Vec3 along_a = a.pose.rotate(a.mesh().edge_vector(pair.edge_a));
    const Vec3 along_b = b.pose.rotate(b.mesh().edge_vector(pair.edge_b));
    const Vec3 cross = along_a.cross(along_b);
    if (cross.norm() < parallel_sine * along_a.norm() * along_b.norm()) continue;
    const Vec3 origin_a = a.vertex(a.mesh().origin(pair.edge_a));
    const Vec3 origin_b = b.vertex(b.mesh().origin(pair.edge_b));
    const Vec3 outward =
        a.pose.rotate(a.mesh().face(a.mesh().edge(pair.edge_a).face).plane.normal +
                      a.mesh().face(a.mesh().edge(pair.edge_a ^ 1).face).plane.normal);
    const Real sign = cross.dot(outward) > 0 ? Real(1) : Real(-1);
    separations.push_back(sign * cross.normalized().dot(origin_b - origin_a));
  }
  return separations;
}

/// Beside the bodies, in the direction that is to the right of the first view.
constexpr Real beside = Real(2.6);

Content show(const AxisSettings& settings) {
  const BodyPair bodies(settings.pair);
  const auto& [shape_a, shape_b, a, b] = bodies;
  const SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
  const std::vector<EdgePair> pairs = crossing_pairs(a, b);

  Content content;
  content.drawing = drawing::draw_axis(a, b, axis);
  if (settings.gauss_maps) {
    Drawing maps = drawing::draw_gauss_maps(a, b, pairs, axis);
    drawing::append(content.drawing,
                    drawing::transformed(maps, {{beside, 0, Real(0.3)}, Quat::Identity()}));
  }
  if (settings.minkowski) {
    drawing::append(content.drawing,
                    drawing::transformed(drawing::draw_minkowski_difference(a, b),
                                         {{-beside, 0, Real(0.3)}, Quat::Identity()}));
  }
  content.plots.push_back(drawing::plot_candidates(
      {face_separations(a, b), face_separations(b, a), edge_separations(a, b, pairs)}));
  content.facts = {
      {"winner", drawing::feature_text(axis)},
      {"separation", quantity(static_cast<double>(axis.separation), "m")},
      {"best face of A",
       axis.face_a ? quantity(static_cast<double>(axis.face_a.separation), "m") : "none"},
      {"best face of B",
       axis.face_b ? quantity(static_cast<double>(axis.face_b.separation), "m") : "none"},
      {"best edges",
       axis.edges ? quantity(static_cast<double>(axis.edges.separation), "m") : "none"},
      {"crossing arcs", std::to_string(pairs.size())}};
  const std::array<PosedShape, 2> both{a, b};
  content.focus = focus_on(content.drawing, both);
  const bool is_flat = !settings.minkowski;  // from this side
  if (is_flat) content.focus.radius *= Real(0.9);
  return content;
}

Vec3 handle(const AxisSettings& settings) { return settings.pair.position; }
void move_handle(AxisSettings& settings, const Vec3& point) { settings.pair.position = point; }

}  // namespace

std::unique_ptr<Page> make_axis_page(Isolation isolation) {
  LabPageParts<AxisSettings> parts;
  parts.lab = 4;
  parts.story =
      "A pair of edges makes a face of the Minkowski difference where their arcs cross on the "
      "Gauss maps of A and −B. Only those pairs and the faces are tried; the largest separation "
      "wins. "
      "Drag B by its middle.";
  parts.first_view = seen_from(Real(-1.5), Real(0.22));
  parts.describe = describe;
  parts.show = show;
  parts.handle = handle;
  parts.move_handle = move_handle;
  return std::make_unique<LabPage<AxisSettings>>(parts, isolation);
}

}  // namespace cs550::viewer
