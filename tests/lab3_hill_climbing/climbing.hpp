#pragma once
// Helpers of the tests of lab 3: shapes to climb, and heights in double precision.

#include <algorithm>
#include <string>
#include <vector>

#include "cs550/hill_climbing.hpp"
#include "drawing/climb_drawing.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/picture.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"

namespace cs550::test {

/// Convex meshes of 4 to 162 vertices: thin, flat, round, with large faces and with tiny ones.
inline const std::vector<std::string>& convex_meshes() {
  static const std::vector<std::string> names{
      "cube",   "box_1x2x3", "slab",    "needle",     "regular_tetrahedron",
      "sliver", "prism6",    "prism32", "pyramid4",   "dodecahedron",
      "hull8",  "hull32",    "hull128", "icosphere2", "triangulated_cube"};
  return names;
}

inline HalfEdgeMesh scaled(HalfEdgeMesh mesh, Real factor) {
  for (Vec3& vertex : mesh.vertices) vertex *= factor;
  for (Face& face : mesh.faces) face.plane.offset *= factor;
  return mesh;
}

inline double height(const Vec3& point, const Vec3& direction) {
  return point.cast<double>().dot(direction.cast<double>());
}

inline double greatest_height(const HalfEdgeMesh& mesh, const Vec3& direction) {
  double greatest = -HUGE_VAL;
  for (const Vec3& vertex : mesh.vertices) {
    greatest = std::max(greatest, height(vertex, direction));
  }
  return greatest;
}

inline double size_of(const HalfEdgeMesh& mesh) {
  double size = 0;
  for (const Vec3& vertex : mesh.vertices) size = std::max(size, double{vertex.norm()});
  return size;
}

/// The resolution of float, with a margin for the climb. It may stop where neighbours are higher by
/// less than a rounding (6e-8 of the size), some edges below the top.
inline double height_tolerance(const HalfEdgeMesh& mesh, const Vec3& direction) {
  return 2e-6 * size_of(mesh) * double{direction.norm()};
}

inline bool is_vertex(const HalfEdgeMesh& mesh, Index v) {
  return v >= 0 && v < mesh.vertex_count();
}

inline std::vector<Index> neighbours(const HalfEdgeMesh& mesh, Index v) {
  std::vector<Index> result;
  for (const Index e : vertex_edges(mesh, v)) result.push_back(mesh.edge(e).vertex);
  return result;
}

/// Directions in which a climb may fail: along face normals (plateaus), edges and axes, and
/// `random_count` random ones.
inline std::vector<Vec3> directions_for(const HalfEdgeMesh& mesh, Random& random,
                                        int random_count) {
  std::vector<Vec3> directions{Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                               -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  const Index few = std::min(Index{6}, mesh.face_count());
  for (Index f = 0; f < few; ++f) directions.push_back(mesh.face(f).plane.normal);
  for (int i = 0; i < random_count; ++i) directions.push_back(random.unit_vector());
  return directions;
}

/// A view from the side, in which a direction points up on the page.
inline drawing::View seen_upright(const Vec3& direction) {
  drawing::View view;
  const Vec3 up = direction.normalized();
  view.up = up;
  view.toward_eye = any_perpendicular(up) + Real(0.35) * up;
  return view;
}

/// A walk with its dot products.
inline std::string walk_picture(const HalfEdgeMesh& mesh, const Vec3& direction,
                                const std::vector<Index>& path) {
  drawing::Drawing walk = drawing::draw_climb(mesh, direction, path, drawing::Role::Got);
  walk.title = "Got: your walk, the direction upward";
  return side_by_side(
      "The walk to the most extreme vertex",
      {drawing::Scene{walk, seen_upright(direction)}, drawing::plot_climb(mesh, direction, path)});
}

inline Index highest_vertex(const HalfEdgeMesh& mesh, const Vec3& direction) {
  Index highest = 0;
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    if (height(mesh.vertex(v), direction) > height(mesh.vertex(highest), direction)) highest = v;
  }
  return highest;
}

/// The most extreme vertex beside the one found.
inline std::string highest_picture(const HalfEdgeMesh& mesh, const Vec3& direction, Index found) {
  const Index highest = highest_vertex(mesh, direction);
  drawing::Drawing expected =
      drawing::draw_climb(mesh, direction, std::span(&highest, 1), drawing::Role::Expected);
  expected.title = "vertex " + std::to_string(highest);
  drawing::Drawing got =
      drawing::draw_climb(mesh, direction, std::span(&found, 1), drawing::Role::Got);
  got.title = "vertex " + std::to_string(found);
  got.points.push_back({mesh.vertex(highest), drawing::Role::Expected, 4});
  expected.legend.clear();
  got.legend.clear();
  // Seen from the side of both vertices.
  drawing::View view = seen_upright(direction);
  Vec3 side = mesh.vertex(highest) + (is_vertex(mesh, found) ? mesh.vertex(found) : Vec3(0, 0, 0));
  side -= side.dot(view.up) * view.up;
  if (side.norm() > 0) view.toward_eye = side.normalized() + Real(0.35) * view.up;
  return expected_beside_got("The most extreme vertex, the direction upward", expected, got, view,
                             "No vertex lies beyond the plane through the most extreme one.");
}

/// A body in the world, with its support point beside the one found. Drawn about the body's position, which
/// may be far from the origin.
inline std::string support_picture(const PosedShape& body, const Vec3& direction,
                                   const SupportPoint& found) {
  const HalfEdgeMesh& mesh = body.mesh();
  const Vec3 turned_back = body.pose.orientation.conjugate() * direction;
  const auto placed = [&](Index vertex, const Vec3& point, drawing::Role role) {
    drawing::Drawing drawing =
        transformed(drawing::draw_climb(mesh, turned_back, std::span(&vertex, 1), role),
                    {Vec3::Zero(), body.pose.orientation});
    drawing.points.push_back({point - body.pose.position, role, 8});
    drawing.title = "vertex " + std::to_string(vertex) + ", a point at " + Story::show(point, "m");
    drawing.legend.clear();
    return drawing;
  };
  const Index highest = highest_vertex(mesh, turned_back);
  return expected_beside_got(
      "The support point in the world, the direction upward",
      placed(highest, body.pose.to_world(mesh.vertex(highest)), drawing::Role::Expected),
      placed(found.vertex, found.point, drawing::Role::Got), seen_upright(direction),
      "The body is drawn about its own position. The large dot is the point returned.");
}

/// Checks that no vertex is higher than the answer.
inline void require_highest(const Story& story, const HalfEdgeMesh& mesh, const Vec3& direction,
                            Index vertex) {
  Story here = story;
  here.given("direction", direction).given("vertices", mesh.vertex_count());
  here.picture([&] { return highest_picture(mesh, direction, vertex); });
  require(here.expect_index("vertex of the answer", vertex, mesh.vertex_count()));
  require(here.expect_near("dot(vertex, direction)", height(mesh.vertex(vertex), direction),
                           greatest_height(mesh, direction), height_tolerance(mesh, direction),
                           "m"));
}

}  // namespace cs550::test
