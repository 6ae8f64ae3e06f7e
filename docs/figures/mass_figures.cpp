#include "figure.hpp"
#include "sketch.hpp"

namespace cs550::book {
namespace {

Page fan() {
  const ShapePtr shape = random_hull(14, 3);
  const HalfEdgeMesh& mesh = shape->mesh;
  Drawing sketch;
  for (Index e = 0; e < mesh.edge_count(); e += 2) {
    sketch.lines.push_back(
        {mesh.vertex(mesh.origin(e)), mesh.vertex(mesh.edge(e).vertex), {Role::BodyA, 1.4f}});
  }
  // The face that looks most towards the reader.
  const Vec3 eye = Vec3(Real(1.3), Real(-2.4), Real(1.3)).normalized();
  Index front = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).plane.normal.dot(eye) > mesh.face(front).plane.normal.dot(eye)) front = f;
  }
  std::vector<Vec3> corners;
  for (const Index e : face_edges(mesh, front)) corners.push_back(mesh.vertex(mesh.edge(e).vertex));
  const Vec3 apex = Vec3::Zero();
  sketch.polygons.push_back({corners, Role::BodyB, Real(0.5)});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sketch.polygons.push_back(
        {{apex, corners[i], corners[(i + 1) % corners.size()]}, Role::BodyB, Real(0.3)});
    sketch.lines.push_back({apex, corners[i], {Role::BodyB, 2, true}});
  }
  add_dot(sketch, apex, Role::Got, "common point", 5);
  return page_of(sketch, {}, {520, 400});
}

}  // namespace

std::vector<Figure> mass_figures() { return {{"fan", fan}}; }

}  // namespace cs550::book
