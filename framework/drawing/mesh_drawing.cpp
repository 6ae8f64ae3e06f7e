#include "drawing/mesh_drawing.hpp"

#include <algorithm>
#include <array>

namespace cs550::drawing {
namespace {

bool has_vertex(const HalfEdgeMesh& mesh, Index v) { return 0 <= v && v < mesh.vertex_count(); }
bool has_edge(const HalfEdgeMesh& mesh, Index e) { return 0 <= e && e < mesh.edge_count(); }
bool has_face(const HalfEdgeMesh& mesh, Index f) { return 0 <= f && f < mesh.face_count(); }

/// The origin of a half-edge: the vertex of its twin or of its predecessor, whichever exists.
Index safe_origin(const HalfEdgeMesh& mesh, Index edge) {
  for (const Index before : {edge ^ 1, mesh.edge(edge).prev}) {
    if (has_edge(mesh, before) && has_vertex(mesh, mesh.edge(before).vertex)) {
      return mesh.edge(before).vertex;
    }
  }
  return no_index;
}

bool has_ends(const HalfEdgeMesh& mesh, Index edge) {
  return has_edge(mesh, edge) && has_vertex(mesh, mesh.edge(edge).vertex) &&
         has_vertex(mesh, safe_origin(mesh, edge));
}

Bounds mesh_bounds(const HalfEdgeMesh& mesh) {
  Bounds box;
  for (const Vec3& vertex : mesh.vertices) {
    if (is_finite(vertex)) box.include(vertex);
  }
  return box;
}

Real size(const HalfEdgeMesh& mesh) {
  return mesh.vertices.empty() ? Real(0) : mesh_bounds(mesh).extent().maxCoeff();
}

/// The half-edges of a face, as far as `next` is valid.
std::vector<Index> safe_loop(const HalfEdgeMesh& mesh, Index face) {
  std::vector<Index> loop;
  if (!has_face(mesh, face)) return loop;
  const Index first = mesh.face(face).edge;
  Index edge = first;
  while (has_edge(mesh, edge) && static_cast<Index>(loop.size()) < mesh.edge_count()) {
    loop.push_back(edge);
    edge = mesh.edge(edge).next;
    if (edge == first) break;
  }
  return loop;
}

std::string printed_index(Index index) { return std::to_string(index); }

/// Newell's normal, because the plane stored in the mesh may be wrong.
Vec3 outward(const Polygon& polygon) {
  Vec3 normal = Vec3::Zero();
  const Vec3 center = middle(polygon.corners);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    normal += (polygon.corners[i] - center)
                  .cross(polygon.corners[(i + 1) % polygon.corners.size()] - center);
  }
  return normal.norm() > 0 ? normal.normalized() : Vec3::Zero();
}

void add_edge(Drawing& drawing, const HalfEdgeMesh& mesh, Index edge, const Stroke& stroke) {
  if (!has_ends(mesh, edge)) return;
  drawing.lines.push_back(
      {mesh.vertex(safe_origin(mesh, edge)), mesh.vertex(mesh.edge(edge).vertex), stroke});
}

}  // namespace

Polygon face_polygon(const HalfEdgeMesh& mesh, Index face, Role role, Real opacity, Real lift) {
  Polygon polygon{{}, role, opacity};
  for (const Index edge : safe_loop(mesh, face)) {
    const Index vertex = mesh.edge(edge).vertex;
    if (has_vertex(mesh, vertex)) polygon.corners.push_back(mesh.vertex(vertex));
  }
  if (lift != 0) {
    const Vec3 offset = lift * size(mesh) * outward(polygon);
    for (Vec3& corner : polygon.corners) corner += offset;
  }
  return polygon;
}

Line half_edge_arrow(const HalfEdgeMesh& mesh, Index edge, const Stroke& stroke, Real inset) {
  if (!has_ends(mesh, edge)) return {};
  Vec3 from = mesh.vertex(safe_origin(mesh, edge));
  Vec3 to = mesh.vertex(mesh.edge(edge).vertex);
  const Polygon face = face_polygon(mesh, mesh.edge(edge).face, stroke.role);
  if (!face.corners.empty()) {
    const Vec3 center = middle(face.corners);
    const Vec3 lift = Real(2e-3) * size(mesh) * outward(face);
    from += inset * (center - from) + lift;
    to += inset * (center - to) + lift;
  }
  Stroke arrow = stroke;
  arrow.arrow = true;
  return {from, to, arrow};
}

Drawing draw_mesh(const HalfEdgeMesh& mesh, const MeshStyle& style) {
  Drawing drawing;
  drawing.title = "Mesh";
  drawing.alt_text = "A mesh of " + printed_index(mesh.vertex_count()) + " vertices, " +
                     printed_index(mesh.edge_count() / 2) + " edges and " +
                     printed_index(mesh.face_count()) + " faces.";
  // All faces of a sound mesh together have as many corners as there are half-edges. Where links are wrong
  // each face may have that many, which would take minutes to draw.
  std::size_t corners = 0;
  for (Index f = 0; f < mesh.face_count() && corners <= 4 * mesh.edges.size(); ++f) {
    Polygon polygon = face_polygon(mesh, f, style.role, style.opacity);
    corners += polygon.corners.size();
    const Vec3 center = middle(polygon.corners);
    const Real length = Real(0.22) * size(mesh);
    if (style.face_numbers) drawing.labels.push_back({center, "f" + printed_index(f), Role::Axis});
    if (style.normals) {
      add_arrow(drawing, center, length * outward(polygon), {style.role, Real(1.6)});
    }
    if (style.opacity > 0 && polygon.corners.size() >= 3) {
      drawing.polygons.push_back(std::move(polygon));
    }
  }
  if (style.edge_width > 0) {
    for (Index e = 0; e < mesh.edge_count(); e += 2) {
      add_edge(drawing, mesh, e, {style.role, style.edge_width, style.dashed});
    }
  }
  if (style.edge_numbers) {
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      if (!has_ends(mesh, e)) continue;
      const Line arrow =
          half_edge_arrow(mesh, e, {.role = Role::Axis, .width = Real(1.2), .arrow = true});
      drawing.labels.push_back({Real(0.5) * (arrow.from + arrow.to), printed_index(e), Role::Axis});
      drawing.lines.push_back(arrow);
    }
  }
  if (style.vertex_numbers) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      drawing.points.push_back({mesh.vertex(v), style.role, 3});
      drawing.labels.push_back({mesh.vertex(v), "v" + printed_index(v), Role::Text});
    }
  }
  return drawing;
}

Drawing draw_body(const PosedShape& body, const MeshStyle& style) {
  return transformed(draw_mesh(body.mesh(), style), body.pose);
}

Drawing draw_half_edge(const HalfEdgeMesh& mesh, Index edge) {
  MeshStyle style;
  style.role = Role::Faint;
  style.opacity = Real(0.75);
  Drawing drawing = draw_mesh(mesh, style);
  drawing.title = "Half-edge " + printed_index(edge);
  if (!has_edge(mesh, edge)) {
    drawing.notes.push_back("There is no half-edge " + printed_index(edge) + ".");
    return drawing;
  }
  const HalfEdge& half_edge = mesh.edge(edge);
  drawing.alt_text += " Half-edge " + printed_index(edge) + " is highlighted, with its next " +
                      printed_index(half_edge.next) + ", prev " + printed_index(half_edge.prev) +
                      ", twin " + printed_index(half_edge.twin) + " and its face " +
                      printed_index(half_edge.face) + ".";

  if (has_face(mesh, half_edge.face)) {
    const Polygon face = face_polygon(mesh, half_edge.face, Role::Reference, Real(0.9), Real(1e-3));
    drawing.labels.push_back(
        {middle(face.corners), "face " + printed_index(half_edge.face), Role::Text});
    drawing.polygons.push_back(face);
  } else {
    drawing.notes.push_back("Its face " + printed_index(half_edge.face) + " does not exist.");
  }
  if (has_vertex(mesh, half_edge.vertex)) {
    const Vec3& end = mesh.vertex(half_edge.vertex);
    drawing.points.push_back({end, Role::Highlight, 5});
    drawing.labels.push_back({end, "vertex " + printed_index(half_edge.vertex), Role::Text});
  } else {
    drawing.notes.push_back("Its vertex " + printed_index(half_edge.vertex) + " does not exist.");
  }

  struct Neighbour {
    Index edge;
    const char* name;
    Stroke stroke;
  };
  const std::array<Neighbour, 4> neighbours = {{
      {half_edge.next, "next", {.role = Role::BodyA, .width = Real(2.4), .arrow = true}},
      {half_edge.prev, "prev", {.role = Role::Incident, .width = Real(2.4), .arrow = true}},
      {half_edge.twin, "twin", {.role = Role::BodyB, .width = Real(2.4), .arrow = true}},
      {edge, "half-edge", {.role = Role::Highlight, .width = Real(3.2), .arrow = true}},
  }};
  for (const Neighbour& neighbour : neighbours) {
    if (!has_ends(mesh, neighbour.edge)) {
      drawing.notes.push_back(std::string("Its ") + neighbour.name + ' ' +
                              printed_index(neighbour.edge) + " does not exist or has no ends.");
      continue;
    }
    const Line arrow = half_edge_arrow(mesh, neighbour.edge, neighbour.stroke);
    drawing.lines.push_back(arrow);
    const std::string name = std::string(neighbour.name) + ' ' + printed_index(neighbour.edge);
    drawing.labels.push_back({Real(0.5) * (arrow.from + arrow.to), name, neighbour.stroke.role});
  }
  return drawing;
}

Drawing draw_mesh_fault(const HalfEdgeMesh& mesh, const std::string& sentence,
                        std::span<const Index> faces, std::span<const Index> edges,
                        std::span<const Index> vertices) {
  MeshStyle style;
  style.role = Role::Faint;
  style.opacity = Real(0.75);
  Drawing drawing = draw_mesh(mesh, style);
  drawing.alt_text += " " + sentence;
  drawing.notes.push_back(sentence);
  for (const Index f : faces) {
    const Polygon polygon = face_polygon(mesh, f, Role::Warning, Real(0.8), Real(1e-3));
    if (polygon.corners.empty()) continue;
    drawing.labels.push_back({middle(polygon.corners), "face " + printed_index(f), Role::Warning});
    if (polygon.corners.size() >= 3) drawing.polygons.push_back(polygon);
  }
  for (const Index e : edges) {
    if (!has_ends(mesh, e)) continue;
    const Line arrow = half_edge_arrow(mesh, e, {.role = Role::Warning, .width = 3, .arrow = true});
    drawing.labels.push_back(
        {Real(0.5) * (arrow.from + arrow.to), "half-edge " + printed_index(e), Role::Warning});
    drawing.lines.push_back(arrow);
  }
  for (const Index v : vertices) {
    if (!has_vertex(mesh, v)) continue;
    drawing.points.push_back({mesh.vertex(v), Role::Warning, 6});
    drawing.labels.push_back({mesh.vertex(v), "vertex " + printed_index(v), Role::Warning});
  }
  return drawing;
}

Drawing draw_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                       const MeshIssue& issue, const MeshStyle& style) {
  Drawing drawing;
  drawing.title = "Triangles";
  drawing.alt_text = printed_index(static_cast<Index>(triangles.size())) + " triangles over " +
                     printed_index(static_cast<Index>(vertices.size())) + " vertices.";
  const auto exists = [&](Index v) {
    return 0 <= v && static_cast<std::size_t>(v) < vertices.size();
  };
  const auto at = [&](Index v) -> const Vec3& { return vertices[v]; };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!std::all_of(triangles[t].begin(), triangles[t].end(), exists)) continue;
    const Index index = static_cast<Index>(t);
    const bool lit = issue && (index == issue.triangle || index == issue.other_triangle);
    const Role role = lit ? Role::Warning : style.role;
    Polygon polygon{
        {at(triangles[t][0]), at(triangles[t][1]), at(triangles[t][2])}, role, style.opacity};
    add_closed_curve(drawing, polygon.corners, {role, style.edge_width, style.dashed});
    if (lit || style.face_numbers) {
      drawing.labels.push_back({middle(polygon.corners), "triangle " + printed_index(index), role});
    }
    drawing.polygons.push_back(std::move(polygon));
  }
  if (issue && exists(issue.edge[0]) && exists(issue.edge[1])) {
    drawing.lines.push_back({at(issue.edge[0]), at(issue.edge[1]), {Role::Warning, 4}});
    for (const Index v : issue.edge) {
      drawing.labels.push_back({at(v), "v" + printed_index(v), Role::Warning});
    }
  }
  if (issue && exists(issue.vertex)) {
    drawing.points.push_back({at(issue.vertex), Role::Warning, 6});
    drawing.labels.push_back({at(issue.vertex), "v" + printed_index(issue.vertex), Role::Warning});
  }
  return drawing;
}

}  // namespace cs550::drawing
