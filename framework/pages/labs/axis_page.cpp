// Lab 4: two bodies, their Gauss maps, and the best axis of each kind.
#include <algorithm>

#include "cs550/separating_axis.hpp"
#include "drawing/gauss_map_drawing.hpp"
#include "drawing/minkowski_drawing.hpp"
#include "pages/base/units.hpp"
#include "pages/labs/body_pair.hpp"
#include "pages/labs/lab_page.hpp"

namespace cs550::pages {
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
  pages::describe(settings.pair, visit);
  visit.section("Show");
  visit.toggle({"gauss_maps", "Gauss maps of A and −B", ""}, settings.gauss_maps);
  visit.toggle({"minkowski", "Minkowski difference", ""}, settings.minkowski);
}

/// The pairs of edges with crossing arcs.
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

/// The results of the three queries as B turns about z by −90 to 90 degrees.
drawing::Plot plot_turning(const PosedShape& a, const PosedShape& b) {
  constexpr int most = 90;  // degrees
  constexpr int step = 3;   // degrees
  std::vector<Vec2> faces_a;
  std::vector<Vec2> faces_b;
  std::vector<Vec2> edges;
  for (int degrees = -most; degrees <= most; degrees += step) {
    PosedShape turned = b;
    const Real angle = pi / 180 * static_cast<Real>(degrees);
    turned.pose.orientation = rotation_exp({0, 0, angle}) * b.pose.orientation;
    const SeparatingAxis axis = find_separating_axis(a, turned, {}, HUGE_VALF);
    const auto x = static_cast<Real>(degrees);
    if (axis.face_a) faces_a.emplace_back(x, axis.face_a.separation);
    if (axis.face_b) faces_b.emplace_back(x, axis.face_b.separation);
    if (axis.edges) edges.emplace_back(x, axis.edges.separation);
  }
  drawing::Plot plot;
  plot.title = "Best separation as B turns";
  plot.alt_text = "The separation of the best face of A, face of B and pair of edges by angle.";
  plot.x_label = "turn of B about z (degrees)";
  plot.y_label = "separation (m)";
  add_series(plot, "face of A", faces_a).role = Role::BodyA;
  add_series(plot, "face of B", faces_b).role = Role::BodyB;
  add_series(plot, "edges", edges).role = Role::Incident;
  plot.marks.push_back({0, true, "now", Role::Axis});
  return plot;
}

std::vector<drawing::LegendEntry> legend_of_bodies() {
  return {{"A", {Role::BodyA, 2}, drawing::LegendMark::Patch},
          {"B", {Role::BodyB, 2}, drawing::LegendMark::Patch},
          {"best axis and its feature", {Role::Axis, 3, false, true}, {}}};
}

const Camera axis_view = seen_from(Real(-1.5), Real(0.22));

/// Moves a drawing beside the bodies, to their right in the initial view.
constexpr Real beside = Real(2.6);

Content show(const AxisSettings& settings) {
  const BodyPair bodies(settings.pair);
  const auto& [shape_a, shape_b, a, b] = bodies;
  const SeparatingAxis axis = find_separating_axis(a, b, {}, HUGE_VALF);
  const std::vector<EdgePair> pairs = crossing_pairs(a, b);

  Content content;
  content.drawing = drawing::draw_axis(a, b, axis, Role::Axis);
  content.drawing.legend = legend_of_bodies();
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
  content.plots.push_back(plot_turning(a, b));
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
  const bool is_flat = !settings.minkowski;  // seen from this side
  if (is_flat) content.focus = closer(content.focus, Real(0.9), both, axis_view);
  return content;
}

std::vector<Handle> handles(const AxisSettings& settings) { return pages::handles(settings.pair); }
void move_handle(AxisSettings& settings, std::size_t handle, const Vec3& point) {
  pages::move_handle(settings.pair, handle, point);
}
void turn_handle(AxisSettings& settings, std::size_t handle, const Vec3& rotation) {
  pages::turn_handle(settings.pair, handle, rotation);
}

}  // namespace

std::unique_ptr<Page> make_axis_page(Isolation isolation) {
  LabPageParts<AxisSettings> parts;
  parts.lab = 4;
  parts.story =
      "Two edges make a face of the Minkowski difference if their arcs cross on the Gauss maps of "
      "A and −B. Only these pairs and the faces are tried, and the largest separation wins. Drag "
      "A or B by its middle to move it, and with the right button to turn it.";
  parts.first_view = axis_view;
  parts.describe = describe;
  parts.show = show;
  parts.handles = handles;
  parts.move_handle = move_handle;
  parts.turn_handle = turn_handle;
  return std::make_unique<LabPage<AxisSettings>>(parts, isolation);
}

}  // namespace cs550::pages
