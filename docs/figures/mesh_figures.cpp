#include "drawing/mesh_drawing.hpp"

#include "cs550/clipping.hpp"
#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

using drawing::MeshStyle;

HalfEdgeMesh triangle_mesh(const TriangleSoup& soup) {
  return build_half_edge_mesh(soup.vertices, soup.triangles).mesh;
}

Page half_edges() {
  const HalfEdgeMesh mesh =
      merge_coplanar_faces(triangle_mesh(box_soup({1, Real(0.8), Real(0.6)})));
  Index shown = 0;  // one that is in front: of the face that looks at the reader
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const bool in_front = mesh.face(mesh.edge(e).face).plane.normal.y() < Real(-0.5);
    if (in_front && mesh.edge_vector(e).z() > Real(0.1)) shown = e;
  }
  Drawing sketch = drawing::draw_half_edge(mesh, shown);
  sketch.title.clear();
  View view;
  view.toward_eye = Vec3(Real(0.9), -2, Real(0.9));
  return page_of(sketch, view, {620, 400});
}

Page merged_box() {
  const HalfEdgeMesh triangles = triangle_mesh(box_soup({1, Real(0.8), Real(0.6)}));
  Drawing before = drawing::draw_mesh(triangles);
  Drawing after = drawing::draw_mesh(merge_coplanar_faces(triangles));
  before.title = std::to_string(triangles.face_count()) + " triangles";
  after.title = std::to_string(merge_coplanar_faces(triangles).face_count()) + " faces";
  return page_of({before, after}, {}, {320, 260});
}

/// Contact points of a box on a platform, from above.
Drawing contacts_on(const HalfEdgeMesh& platform, Role role) {
  const ShapeResult top = make_shape(platform);
  const ShapePtr small = box({Real(0.7), Real(0.7), Real(0.5)});
  const PosedShape a{top.shape.get(), {}};
  const PosedShape b{small.get(), {Vec3(0, 0, Real(0.49) + Real(0.3)), Quat::Identity()}};
  const SeparatingAxis axis = find_separating_axis(a, b, {}, Real(0.1));
  SeparatingAxis on_a = axis;
  on_a.feature = AxisFeature::FaceA;
  const Manifold manifold = face_manifold(a, b, on_a, Real(0.1));

  Drawing sketch = drawing::draw_body(a, {Role::BodyA, Real(0.35)});
  const auto corner = [](double x, double y) { return Vec3(at(x, y) + Vec3(0, 0, Real(0.31))); };
  add_outline(sketch, {corner(-0.7, -0.7), corner(0.7, -0.7), corner(0.7, 0.7), corner(-0.7, 0.7)},
              {Role::BodyB, 2.5f});
  std::vector<Vec3> points;
  for (const ContactPoint& point : manifold.points) {
    Vec3 shown = a.pose.to_world(point.anchor_a);
    shown.z() = Real(0.32);
    points.push_back(shown);
    add_dot(sketch, shown, role, "", 7);
  }
  sketch.polygons.push_back({flat_hull(points), role, Real(0.45)});
  add_dot(sketch, Vec3(0, 0, Real(0.4)), Role::Text, "centre of mass");
  return sketch;
}

Page unmerged() {
  const HalfEdgeMesh triangles = triangle_mesh(box_soup({1, 1, Real(0.3)}));
  Drawing wrong = contacts_on(triangles, Role::Got);
  Drawing right = contacts_on(merge_coplanar_faces(triangles), Role::Expected);
  wrong.title = "reference face: a triangle";
  right.title = "reference face: the merged square";
  return page_of({wrong, right}, drawing::view_from_above(), {310, 310});
}

/// A round prism whose sides are coloured by the face that they belong to.
Drawing prism_in_faces(int sides, bool chained) {
  Drawing sketch;
  const std::vector<Vec3> rim = regular_polygon(sides, at(0, 0), 1);
  const Vec3 up(0, 0, Real(1.1));
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t next = (i + 1) % rim.size();
    const Role role = chained ? Role::Got : i % 2 == 0 ? Role::BodyA : Role::Reference;
    sketch.polygons.push_back({{rim[i], rim[next], rim[next] + up, rim[i] + up}, role, 1});
    if (!chained) sketch.lines.push_back({rim[i], rim[i] + up, {Role::Text, 0.8f}});
  }
  std::vector<Vec3> top;
  top.reserve(rim.size());
  for (const Vec3& corner : rim) top.push_back(corner + up);
  sketch.polygons.push_back({top, Role::Faint, 1});
  return sketch;
}

Page not_transitive() {
  Drawing wrong = prism_in_faces(48, true);
  Drawing right = prism_in_faces(48, false);
  wrong.title = "neighbours compared: one face";
  right.title = "merged face judged: 48 faces";
  return page_of({wrong, right}, {}, {320, 260});
}

}  // namespace

std::vector<Figure> mesh_figures() {
  return {{"half_edges", half_edges},
          {"merged_box", merged_box},
          {"unmerged", unmerged},
          {"not_transitive", not_transitive}};
}

}  // namespace cs550::book
