#include "pages/labs/shapes.hpp"

#include <algorithm>
#include <stdexcept>

#include "cs550/assets.hpp"
#include "cs550/mesh_io.hpp"
#include "pages/base/colours.hpp"

namespace cs550::pages {
namespace {

HalfEdgeMesh scaled(HalfEdgeMesh mesh, Real factor) {
  for (Vec3& vertex : mesh.vertices) vertex *= factor;
  for (Face& face : mesh.faces) face.plane.offset *= factor;
  return mesh;
}

}  // namespace

ShapePtr recorded_shape(int name, Real radius) {
  constexpr std::array<const char*, 7> files{"unit_box.json",  "regular_tetrahedron.json",
                                             "prism6.json",    "dodecahedron.json",
                                             "hull16.json",    "hull32.json",
                                             "icosphere2.json"};
  const auto file = assets_folder() / "meshes" / files.at(name);
  const MeshResult loaded = load_mesh_json(file);
  if (!loaded.error.empty()) throw std::runtime_error(loaded.error);
  const ShapeResult measured = make_shape(loaded.mesh);
  if (!measured) throw std::runtime_error(measured.error);
  // All shapes have the same radius, so that pages do not depend on the size of a shape.
  const ShapeResult result = make_shape(scaled(loaded.mesh, radius / measured.shape->radius));
  if (!result) throw std::runtime_error(result.error);
  return result.shape;
}

Pose pose_from(const Vec3& position, const Vec3& turn_degrees) {
  const Vec3 turn = pi / 180 * turn_degrees;
  const Quat orientation = rotation_exp({0, 0, turn.z()}) * rotation_exp({0, turn.y(), 0}) *
                           rotation_exp({turn.x(), 0, 0});
  return {position, orientation};
}

Vec3 turn_degrees(const Quat& orientation) {
  const Mat3 r = orientation.toRotationMatrix();
  const Real x = std::atan2(r(2, 1), r(2, 2));
  const Real y = std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2)));
  // From what remains after the turn about x is taken back: where y is a right angle, r(0, 0) and
  // r(1, 0) vanish.
  const Real z = std::atan2(std::sin(x) * r(0, 2) - std::cos(x) * r(0, 1),
                            std::cos(x) * r(1, 1) - std::sin(x) * r(1, 2));
  return (180 / pi * Vec3(x, y, z)).cwiseMax(-180).cwiseMin(180);
}

Solid solid_of(const PosedShape& body, drawing::Role role, float opacity) {
  Solid solid;
  solid.mesh = std::make_shared<const HalfEdgeMesh>(body.mesh());
  solid.pose = body.pose;
  solid.colour = role_rgba(role, opacity);
  return solid;
}

Solid light_solid(const HalfEdgeMesh& mesh) {
  Solid solid;
  solid.mesh = std::make_shared<const HalfEdgeMesh>(mesh);
  solid.colour = {0.80F, 0.87F, 0.93F, 1};
  return solid;
}

drawing::Drawing scaled(drawing::Drawing drawing, Real factor) {
  for (auto& point : drawing.points) point.position *= factor;
  for (auto& line : drawing.lines) {
    line.from *= factor;
    line.to *= factor;
  }
  for (auto& polygon : drawing.polygons) {
    for (auto& corner : polygon.corners) corner *= factor;
  }
  for (auto& ball : drawing.balls) {
    ball.center *= factor;
    ball.radius *= factor;
  }
  for (auto& label : drawing.labels) label.position *= factor;
  return drawing;
}

drawing::Drawing without_faces(drawing::Drawing drawing, drawing::Role role) {
  std::erase_if(drawing.polygons,
                [&](const drawing::Polygon& polygon) { return polygon.role == role; });
  std::erase_if(drawing.lines, [&](const drawing::Line& line) {
    return line.stroke.role == role && !line.stroke.arrow;
  });
  return drawing;
}

Focus focus_on(const drawing::Drawing& drawing, std::span<const PosedShape> bodies) {
  Bounds all = drawing::bounds(drawing::finite_part(drawing));
  for (const PosedShape& body : bodies) all.include(world_bounds(body));
  if (!(all.lower.array() <= all.upper.array()).all()) return {};
  return focus_of(all);
}

Focus closer(Focus focus, Real factor, std::span<const PosedShape> bodies, const Camera& view) {
  focus.radius *= factor;
  for (const PosedShape& body : bodies) {
    for (Index v = 0; v < body.mesh().vertex_count(); ++v) {
      const Real least = radius_that_shows(view, focus.center, body.vertex(v));
      focus.radius = std::max(focus.radius, least);
    }
  }
  return focus;
}

}  // namespace cs550::pages
