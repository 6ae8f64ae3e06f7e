#pragma once
/// @file test_bodies.hpp
/// Bodies for tests of the world.

#include <stdexcept>
#include <vector>

#include "cs550/primitives.hpp"
#include "cs550/world.hpp"
#include "helpers/random.hpp"

namespace cs550::test {

inline ShapePtr shape_of(const TriangleSoup& soup) {
  const ShapeResult result = make_shape(soup.vertices, soup.triangles);
  if (!result) throw std::runtime_error(result.error);
  return result.shape;
}

inline ShapePtr box_shape(const Vec3& half_extents) { return shape_of(box_soup(half_extents)); }

/// A cube of 1 m.
inline const ShapePtr& unit_box() {
  static const ShapePtr shape = box_shape(Vec3::Constant(Real(0.5)));
  return shape;
}

/// The hull of random points on an ellipsoid.
inline ShapePtr random_hull(Random& random, int vertices, const Vec3& radii) {
  std::vector<Vec3> points =
      random_sphere_points(vertices, static_cast<std::uint32_t>(random.integer(0, 1 << 30)));
  for (Vec3& point : points) point = point.cwiseProduct(radii);
  const SoupResult hull = convex_hull(points);
  if (!hull.error.empty()) throw std::runtime_error(hull.error);
  return shape_of(hull.soup);
}

inline BodyDef body_at(const ShapePtr& shape, const Vec3& position,
                       BodyKind kind = BodyKind::Dynamic) {
  BodyDef def;
  def.kind = kind;
  def.shape = shape;
  def.pose.position = position;
  return def;
}

/// A floor whose upper side is the plane z = 0.
inline BodyDef floor_body(Real half_width = 20) {
  return body_at(box_shape({half_width, half_width, Real(0.5)}), {0, 0, Real(-0.5)},
                 BodyKind::Static);
}

inline constexpr Real step_length = Real(1) / 60;

inline void run(World& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step(step_length);
}

/// A floor and hulls that fall onto it in a heap.
inline World falling_hulls(int count, std::uint32_t seed) {
  Random random(seed);
  World world;
  world.add_body(floor_body());
  for (int i = 0; i < count; ++i) {
    const int vertices = random.integer(8, 24);
    const ShapePtr shape = random_hull(random, vertices, Vec3::Constant(Real(0.4)));
    const Real x = random.real(-1, 1);
    const Real y = random.real(-1, 1);
    BodyDef def = body_at(shape, {x, y, 1 + Real(i)});
    def.pose.orientation = random.orientation();
    world.add_body(def);
  }
  return world;
}

}  // namespace cs550::test
