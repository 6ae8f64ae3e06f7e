// Lab 2: a walk over half-edges, before and after merging, and defects of triangles and meshes.
#include <cmath>
#include <utility>

#include "cs550/half_edge_mesh.hpp"
#include "cs550/mesh_validation.hpp"
#include "cs550/primitives.hpp"
#include "drawing/mesh_drawing.hpp"
#include "pages/labs/lab_page.hpp"
#include "pages/labs/shapes.hpp"

namespace cs550::pages {
namespace {

using drawing::Drawing;

constexpr std::array<const char*, 4> solid_names{"box", "prism", "tetrahedron", "icosahedron"};
constexpr std::array<const char*, 4> fault_names{"none", "hole", "flipped", "inside_out"};
enum Fault { None, Hole, Flipped, InsideOut };

constexpr std::array<const char*, 4> move_names{"next", "prev", "twin", "face"};
enum Move { Next, Prev, Twin, FaceEdge };

constexpr Real first_yaw = Real(-1.1);
constexpr Real first_pitch = Real(0.5);

/// As the half-edge where a walk begins: one that the first view shows from the front, however the student's
/// code numbers them. It is called "front".
constexpr int edge_in_front = -1;

struct HalfEdgeSettings {
  int solid = 1;
  bool merged = true;
  int fault = None;
  int edge = edge_in_front;
  std::vector<int> walk;
  int step = last_step;

  bool operator==(const HalfEdgeSettings&) const = default;
};

void describe(HalfEdgeSettings& settings, ControlVisitor& visit) {
  visit.section("Walk");
  visit.whole({.name = "edge", .label = "begin at half-edge", .unit = "", .minus_one = "front"},
              settings.edge, edge_in_front, 119);
  visit.moves({"walk", "walk", ""}, settings.walk, move_names);
  visit.step({"step", "shown step", ""}, settings.step, 100);
  visit.section("Mesh");
  visit.choice({"solid", "solid", ""}, settings.solid, solid_names);
  visit.toggle({"merged", "merge coplanar faces", ""}, settings.merged);
  visit.choice({"fault", "fault in the input", ""}, settings.fault, fault_names);
}

/// A tetrahedron in the middle of the picture, where tetrahedron_soup() has the corner of its right angles.
TriangleSoup centred_tetrahedron(Real side) {
  TriangleSoup soup = tetrahedron_soup(side);
  for (Vec3& vertex : soup.vertices) vertex -= Vec3::Constant(side / 4);
  return soup;
}

TriangleSoup triangles_of(const HalfEdgeSettings& settings) {
  TriangleSoup soup;
  switch (settings.solid) {
    case 0:
      soup = box_soup({Real(0.7), Real(0.55), Real(0.45)});
      break;
    case 1:
      soup = prism_soup(6, Real(0.8), Real(0.5));
      break;
    case 2:
      soup = centred_tetrahedron(Real(1.35));
      break;
    default:
      soup = icosphere_soup(0, Real(0.9));
  }
  if (settings.fault == Hole) soup.triangles.erase(soup.triangles.begin() + 1);
  if (settings.fault == Flipped) std::swap(soup.triangles[1][0], soup.triangles[1][1]);
  if (settings.fault == InsideOut) {
    for (Triangle& triangle : soup.triangles) std::swap(triangle[0], triangle[1]);
  }
  return soup;
}

/// Of the edges between two faces that look towards the eye, the half-edge that does so most.
Index find_edge_in_front(const HalfEdgeMesh& mesh) {
  const Vec3 toward_eye(std::cos(first_pitch) * std::cos(first_yaw),
                        std::cos(first_pitch) * std::sin(first_yaw), std::sin(first_pitch));
  const auto facing = [&](Index e) {
    return mesh.face(mesh.edge(e).face).plane.normal.dot(toward_eye);
  };
  const auto rank = [&](Index e) {
    return std::pair(std::min(facing(e), facing(e ^ 1)), facing(e));
  };
  Index best = 0;
  for (Index e = 1; e < mesh.edge_count(); ++e) {
    if (rank(e) > rank(best)) best = e;
  }
  return best;
}

/// The half-edge at the end of a walk. Links of unfinished code may be invalid.
Index walk(const HalfEdgeMesh& mesh, Index edge, std::span<const int> moves) {
  for (const int move : moves) {
    if (edge < 0 || edge >= mesh.edge_count()) return edge;
    const HalfEdge& here = mesh.edge(edge);
    if (move == Next) edge = here.next;
    if (move == Prev) edge = here.prev;
    if (move == Twin) edge = here.twin;
    if (move == FaceEdge) {
      const bool exists = here.face >= 0 && here.face < mesh.face_count();
      edge = exists ? mesh.face(here.face).edge : no_index;
    }
  }
  return edge;
}

/// The elements of a defect, as lists for draw_mesh_fault().
Drawing draw_defect(const HalfEdgeMesh& mesh, const MeshDefect& defect) {
  const std::vector<Index> here{defect.index};
  const std::vector<Index> nothing;
  const auto if_is = [&](MeshElement element) {
    return std::span<const Index>(defect.element == element ? here : nothing);
  };
  return drawing::draw_mesh_fault(mesh, defect.sentence, if_is(MeshElement::Face),
                                  if_is(MeshElement::HalfEdge), if_is(MeshElement::Vertex));
}

/// Light triangles with dark edges, so that the defective ones stand out. Triangles with the wrong
/// winding show their normals.
Drawing draw_refused(const TriangleSoup& soup, const MeshIssue& issue) {
  const bool all_are_wrong = issue.error == MeshError::InsideOut;
  const drawing::MeshStyle quiet = {.role = drawing::Role::Faint,
                                    .opacity = all_are_wrong ? Real(0.3) : Real(0.8)};
  Drawing drawing = drawing::draw_triangles(soup.vertices, soup.triangles, issue, quiet);
  for (drawing::Line& line : drawing.lines) {
    if (line.stroke.role == drawing::Role::Faint) line.stroke.role = drawing::Role::Axis;
  }
  for (drawing::Polygon& polygon : drawing.polygons) {
    if (polygon.role == drawing::Role::Warning) polygon.opacity = Real(0.9);
    if (!all_are_wrong) continue;
    const Vec3 normal = (polygon.corners[1] - polygon.corners[0])
                            .cross(polygon.corners[2] - polygon.corners[0])
                            .normalized();
    drawing::add_arrow(drawing, drawing::middle(polygon.corners), Real(0.3) * normal,
                       {drawing::Role::Warning, Real(2.5), false, true});
  }
  drawing.legend.push_back({all_are_wrong ? "outward according to the triangles" : "at fault",
                            {drawing::Role::Warning, 3, false, all_are_wrong}});
  return drawing;
}

std::vector<drawing::LegendEntry> legend_of_walk() {
  using drawing::Role;
  return {{"half-edge", {Role::Highlight, 3, false, true}, {}},
          {"its vertex", {Role::Highlight, 3}, drawing::LegendMark::Dot},
          {"its face", {Role::Reference, 2}, drawing::LegendMark::Patch},
          {"next", {Role::BodyA, 2, false, true}, {}},
          {"prev", {Role::Incident, 2, false, true}, {}},
          {"twin", {Role::BodyB, 2, false, true}, {}}};
}

std::string count_text(const HalfEdgeMesh& mesh) {
  return std::to_string(mesh.vertex_count()) + " − " + std::to_string(mesh.edge_count() / 2) +
         " + " + std::to_string(mesh.face_count()) + " = " +
         std::to_string(mesh.vertex_count() - mesh.edge_count() / 2 + mesh.face_count());
}

void show_walk(const HalfEdgeSettings& settings, const HalfEdgeMesh& mesh, Content& content) {
  content.step_count = static_cast<int>(settings.walk.size()) + 1;
  const int step = shown_step(settings.step, content.step_count);
  const Index start = settings.edge == edge_in_front
                          ? find_edge_in_front(mesh)
                          : std::min<Index>(settings.edge, mesh.edge_count() - 1);
  const Index edge = walk(mesh, start, {settings.walk.data(), static_cast<std::size_t>(step)});
  content.drawing = without_faces(drawing::draw_half_edge(mesh, edge), drawing::Role::Faint);
  content.drawing.legend = legend_of_walk();
  content.solids.push_back(light_solid(mesh));
  content.facts.push_back({"half-edge", std::to_string(edge)});
  if (edge < 0 || edge >= mesh.edge_count()) return;
  const HalfEdge& here = mesh.edge(edge);
  content.facts.push_back(
      {"next, prev", std::to_string(here.next) + ", " + std::to_string(here.prev)});
  content.facts.push_back({"twin", std::to_string(here.twin)});
  content.facts.push_back(
      {"vertex, face", std::to_string(here.vertex) + ", " + std::to_string(here.face)});
}

Content show(const HalfEdgeSettings& settings) {
  const TriangleSoup soup = triangles_of(settings);
  const MeshBuild built = build_half_edge_mesh(soup.vertices, soup.triangles);
  Content content;
  if (built.issue) {
    content.drawing = draw_refused(soup, built.issue);
    content.facts = {{"refused", describe(built.issue)}};
  } else {
    const HalfEdgeMesh mesh = settings.merged ? merge_coplanar_faces(built.mesh) : built.mesh;
    content.facts = {{"V − E + F", count_text(mesh)}};
    const std::optional<MeshDefect> defect = validate(mesh);
    if (defect) {
      content.drawing = draw_defect(mesh, *defect);
      content.facts.push_back({"broken", defect->sentence});
    } else {
      show_walk(settings, mesh, content);
    }
  }
  content.focus = {Vec3::Zero(), Real(1.15)};
  return content;
}

}  // namespace

std::unique_ptr<Page> make_half_edge_page(Isolation isolation) {
  LabPageParts<HalfEdgeSettings> parts;
  parts.lab = 2;
  parts.story =
      "A half-edge stores its next, prev, twin, vertex and face: enough to reach every other one. "
      "Merging turns coplanar triangles into one polygon; faulty triangles are rejected.";
  parts.first_view = seen_from(first_yaw, first_pitch);
  parts.describe = describe;
  parts.show = show;
  return std::make_unique<LabPage<HalfEdgeSettings>>(parts, isolation);
}

}  // namespace cs550::pages
