// Faces of many corners that turn inward as far as validate() lets them.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cs550/clipping.hpp"
#include "cs550/diagnostics.hpp"
#include "engine/test_bodies.hpp"

namespace cs550 {
namespace {

using namespace test;
using Vec2d = Eigen::Vector2d;

constexpr Real half_height = Real(0.2);

/// A prism over a polygon. The half-edges of side i begin at 6·i: along the bottom and back, along the top and back, and
/// up its first corner and down.
ShapePtr prism_over(const std::vector<Vec2d>& outline) {
  const auto n = static_cast<Index>(outline.size());
  const auto after = [n](Index i) { return (i + 1) % n; };
  const auto before = [n](Index i) { return (i + n - 1) % n; };
  HalfEdgeMesh mesh;
  for (const Real z : {-half_height, half_height}) {
    for (const Vec2d& corner : outline) {
      mesh.vertices.emplace_back(static_cast<Real>(corner.x()), static_cast<Real>(corner.y()), z);
    }
  }
  const Index bottom = n;
  const Index top = n + 1;
  for (Index i = 0; i < n; ++i) {
    const Index j = after(i);
    const Index e = 6 * i;
    mesh.edges.push_back({j, 6 * j + 4, e + 5, e + 1, i});
    mesh.edges.push_back({i, 6 * before(i) + 1, 6 * j + 1, e, bottom});
    mesh.edges.push_back({n + i, e + 5, 6 * j + 4, e + 3, i});
    mesh.edges.push_back({n + j, 6 * j + 3, 6 * before(i) + 3, e + 2, top});
    mesh.edges.push_back({n + i, 6 * before(i) + 2, 6 * before(i), e + 5, before(i)});
    mesh.edges.push_back({i, e, e + 2, e + 4, i});
    mesh.faces.push_back({e, {}});
  }
  mesh.faces.push_back({1, {}});
  mesh.faces.push_back({3, {}});
  for (Index i = 0; i < n; ++i) mesh.vertex_edge.push_back(6 * i);
  for (Index i = 0; i < n; ++i) mesh.vertex_edge.push_back(6 * i + 3);
  for (Index f = 0; f < mesh.face_count(); ++f) mesh.faces[f].plane = face_plane(mesh, f);
  const ShapeResult shape = make_shape(mesh);
  if (!shape) throw std::runtime_error(shape.error);
  return shape.shape;
}

constexpr int sides = 64;
constexpr double sector = 2 * M_PI / sides;
const double apothem = std::cos(sector / 2);

/// A regular polygon of radius 1 m, with a corner more in the middle of each side, 90 µm inside.
std::vector<Vec2d> dented_outline() {
  std::vector<Vec2d> outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = i * sector;
    outline.emplace_back(std::cos(angle), std::sin(angle));
    outline.push_back((apothem - 9e-5) *
                      Vec2d(std::cos(angle + sector / 2), std::sin(angle + sector / 2)));
  }
  return outline;
}

/// A convex polygon of 128 sides, in turn across a corner and across a dent of the other one, whose side planes lie
/// `moved` farther out.
std::vector<Vec2d> cutting_outline(double moved) {
  const auto distance = [moved](int i) { return (i % 2 == 1 ? apothem - 1e-5 : 1 - 1e-4) - moved; };
  std::vector<Vec2d> outline;
  for (int i = 0; i < 2 * sides; ++i) {
    const double angle = i * sector / 2;
    const double next = (i + 1) * sector / 2;
    Eigen::Matrix2d normals;
    normals << std::cos(angle), std::sin(angle), std::cos(next), std::sin(next);
    outline.emplace_back(normals.inverse() * Vec2d(distance(i), distance(i + 1)));
  }
  return outline;
}

/// How many corners remain at most while a polygon is clipped by the sides of a convex one.
std::size_t most_corners(std::vector<Vec2d> polygon, const std::vector<Vec2d>& by, double moved) {
  std::size_t most = polygon.size();
  for (std::size_t side = 0; side < by.size(); ++side) {
    const Vec2d along = (by[(side + 1) % by.size()] - by[side]).normalized();
    const Vec2d normal(along.y(), -along.x());
    const auto outside = [&](const Vec2d& p) { return normal.dot(p - by[side]) - moved; };
    std::vector<Vec2d> clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2d& next = polygon[(i + 1) % polygon.size()];
      const double here = outside(polygon[i]);
      const double there = outside(next);
      if (here <= 0) clipped.push_back(polygon[i]);
      if (here * there < 0) {
        clipped.emplace_back(polygon[i] + here / (here - there) * (next - polygon[i]));
      }
    }
    polygon = clipped;
    most = std::max(most, polygon.size());
  }
  return most;
}

TEST(DentedFaces, HaveRoomForAllCornersThatClippingMakes) {
  const std::vector<Vec2d> dented = dented_outline();
  const ShapePtr body = prism_over(dented);
  const double moved = double{side_plane_tolerance} * double{body->radius};
  const std::vector<Vec2d> cutting = cutting_outline(moved);
  ASSERT_GT(most_corners(dented, cutting, moved), 2 * std::size_t{max_face_vertices})
      << "as many as two convex faces leave";

  World world;
  world.add_body(body_at(prism_over(cutting), Vec3::Zero(), BodyKind::Static));
  world.add_body(body_at(body, {0, 0, 2 * half_height}));
  world.step(step_length);
  ASSERT_EQ(world.contacts().size(), 1U);
  EXPECT_EQ(world.contacts()[0].manifold.points.size(), 4);
  run(world, 60);
  EXPECT_TRUE(is_finite(world));
  EXPECT_NEAR(world.bodies()[1].pose.position.z(), 2 * half_height, 1e-3);
}

}  // namespace
}  // namespace cs550
