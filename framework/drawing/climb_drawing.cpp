#include "drawing/climb_drawing.hpp"

#include <algorithm>

#include "drawing/mesh_drawing.hpp"
#include "drawing/text.hpp"

namespace cs550::drawing {
namespace {

/// A wrong walk may be endless. Its beginning shows the mistake.
constexpr std::size_t longest_walk = 60;

bool exists(const HalfEdgeMesh& mesh, Index v) { return 0 <= v && v < mesh.vertex_count(); }

Vec3 unit(const Vec3& direction) {
  const Real length = direction.norm();
  return length > 0 && std::isfinite(length) ? Vec3(direction / length) : Vec3::UnitZ();
}

Real highest(const HalfEdgeMesh& mesh, const Vec3& direction) {
  Real result = -HUGE_VALF;
  for (const Vec3& vertex : mesh.vertices) result = std::max(result, vertex.dot(direction));
  return result;
}

std::string dot_text(Index vertex, Real dot) {
  return "v" + std::to_string(vertex) + ": " + number_text(static_cast<double>(dot));
}

Bounds bounds_of(const HalfEdgeMesh& mesh) {
  Bounds box;
  for (const Vec3& vertex : mesh.vertices) box.include(vertex);
  return box;
}

/// Whether a vertex is beyond the plane through another one, by more than rounding.
bool is_any_beyond(const HalfEdgeMesh& mesh, const Vec3& through, const Vec3& normal, Real size) {
  return highest(mesh, normal) - through.dot(normal) > Real(1e-5) * size;
}

/// A square through a point, perpendicular to a direction.
Polygon support_plane(const Vec3& through, const Vec3& normal, Real half_side) {
  const Vec3 u = half_side * any_perpendicular(normal);
  const Vec3 v = normal.cross(u);
  return {{through - u - v, through + u - v, through + u + v, through - u + v},
          Role::Faint,
          Real(0.35)};
}

}  // namespace

ClimbArrow climb_arrow(const HalfEdgeMesh& mesh, const Vec3& direction) {
  if (mesh.vertices.empty()) return {};
  const Bounds box = bounds_of(mesh);
  const Vec3 across = box.extent().maxCoeff() * unit(direction);
  const Vec3 tail = box.center() + Real(0.62) * across;
  return {box.center(), tail, tail + Real(0.4) * across};
}

Drawing draw_climb(const HalfEdgeMesh& mesh, const Vec3& direction, std::span<const Index> path,
                   Role role) {
  const std::size_t length = path.size();
  path = path.first(std::min(length, longest_walk));
  MeshStyle style;
  style.role = Role::BodyA;
  style.opacity = Real(0.72);
  style.edge_width = 1;
  Drawing drawing = draw_mesh(mesh, style);
  drawing.title = "Walk of " + std::to_string(length) + (length == 1 ? " vertex" : " vertices");
  if (length > longest_walk) drawing.notes.push_back("Only the beginning of the walk is drawn.");
  if (mesh.vertices.empty()) return drawing;

  const Vec3 up = unit(direction);
  const Real size = bounds_of(mesh).extent().maxCoeff();

  Index last = no_index;
  for (const Index v : path) {
    if (!exists(mesh, v)) {
      drawing.notes.push_back("The path names vertex " + std::to_string(v) +
                              ", which does not exist.");
      continue;
    }
    for (const Index e : vertex_edges(mesh, v)) {
      drawing.points.push_back({mesh.vertex(mesh.edge(e).vertex), Role::Faint, 3});
    }
    if (last != no_index) {
      drawing.lines.push_back(
          {mesh.vertex(last), mesh.vertex(v), {.role = role, .width = 3, .arrow = true}});
    }
    last = v;
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!exists(mesh, path[i])) continue;
    const Vec3& vertex = mesh.vertex(path[i]);
    drawing.points.push_back({vertex, role, i == 0 || i + 1 == path.size() ? Real(5.5) : Real(4)});
    drawing.labels.push_back({vertex, dot_text(path[i], vertex.dot(direction)), Role::Text});
  }
  const ClimbArrow arrow = climb_arrow(mesh, direction);
  add_arrow(drawing, arrow.tail, arrow.tip - arrow.tail, {Role::Axis, Real(2.5)}, "direction");
  drawing.legend = {{"walk", {role, 3}, LegendMark::Line}};

  if (last != no_index) {
    const Vec3& end = mesh.vertex(last);
    drawing.polygons.push_back(support_plane(end, up, Real(0.35) * size));
    // A walk that is shown step by step, or a wrong one, may not have reached the end.
    const char* meaning = is_any_beyond(mesh, end, up, size)
                              ? "vertices are beyond this plane: walk on"
                              : "no vertex beyond this plane";
    drawing.legend.push_back({meaning, {Role::Faint, 2}, LegendMark::Patch});
    const Real missing = highest(mesh, direction) - end.dot(direction);
    drawing.alt_text += " A walk from vertex " + std::to_string(path.front()) + " to vertex " +
                        std::to_string(last) + " in " + std::to_string(path.size() - 1) + " steps" +
                        (missing > 0 ? ", which is not the most extreme one." : ".");
  }
  return drawing;
}

Plot plot_climb(const HalfEdgeMesh& mesh, const Vec3& direction, std::span<const Index> path) {
  Plot plot;
  plot.title = "Dot product along the walk";
  plot.alt_text = "The dot product of vertex and direction at each step of the walk.";
  plot.x_label = "step";
  plot.y_label = "vertex · direction";
  std::vector<Vec2> values;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!exists(mesh, path[i])) continue;
    values.emplace_back(static_cast<Real>(i), mesh.vertex(path[i]).dot(direction));
  }
  add_series(plot, "", values).role = Role::Faint;
  add_series(plot, "vertices stood on", values, SeriesStyle::Dots).role = Role::BodyA;
  if (!mesh.vertices.empty()) {
    plot.marks.push_back({highest(mesh, direction), false, "most extreme", Role::Expected});
  }
  return plot;
}

}  // namespace cs550::drawing
