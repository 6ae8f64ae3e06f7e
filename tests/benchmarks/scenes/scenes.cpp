#include "benchmarks/scenes/scenes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cs550/primitives.hpp"
#include "helpers/random.hpp"

namespace cs550::bench {
namespace {

using test::Random;

constexpr Real half_cube = Real(0.5);
constexpr Real half_ground = 50;

ShapePtr shape_of(const TriangleSoup& soup) {
  ShapeResult result = make_shape(soup.vertices, soup.triangles);
  if (!result) throw std::runtime_error(result.error);
  return result.shape;
}

ShapePtr hull_of(std::span<const Vec3> points) {
  const SoupResult hull = convex_hull(points);
  if (!hull.error.empty()) throw std::runtime_error(hull.error);
  return shape_of(hull.soup);
}

/// Other engines store a diagonal inertia.
ShapePtr hull_in_principal_axes(std::vector<Vec3> points) {
  const Eigen::Matrix3f inertia = hull_of(points)->unit_inertia;
  Eigen::Matrix3f axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(inertia).eigenvectors();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  for (Vec3& point : points) point = axes.transpose() * point;
  return hull_of(points);
}

ShapePtr random_hull(int vertices, std::uint32_t seed) {
  std::vector<Vec3> points = random_sphere_points(vertices, seed);
  for (Vec3& point : points) point *= Real(0.5);
  return hull_in_principal_axes(std::move(points));
}

void add_static_box(BenchScene& scene, const Vec3& centre, const Vec3& half_extents) {
  BodyDef wall;
  wall.kind = BodyKind::Static;
  wall.shape = shape_of(box_soup(half_extents));
  wall.pose.position = centre;
  scene.bodies.push_back(wall);
}

BenchScene on_the_ground() {
  BenchScene scene;
  scene.half_width = half_ground;
  add_static_box(scene, {0, 0, -1}, {half_ground, half_ground, 1});
  return scene;
}

/// A square room with walls of 20 m. @param width inside (m)
BenchScene in_a_room(Real width) {
  BenchScene scene = on_the_ground();
  scene.half_width = width / 2;
  constexpr Real half_wall = Real(0.5), half_height = 10;
  const Real middle = width / 2 + half_wall;
  for (const Real side : {Real(-1), Real(1)}) {
    add_static_box(scene, {side * middle, 0, half_height},
                   {half_wall, middle + half_wall, half_height});
    add_static_box(scene, {0, side * middle, half_height}, {width / 2, half_wall, half_height});
  }
  return scene;
}

void add_body(BenchScene& scene, const ShapePtr& shape, const Pose& pose) {
  BodyDef body;
  body.shape = shape;
  body.pose = pose;
  scene.bodies.push_back(body);
}

/// The place of one of `count` bodies in a row that is centred at 0.
Real along_row(int i, int count, Real spacing) {
  return (static_cast<Real>(i) - static_cast<Real>(count - 1) / 2) * spacing;
}

BenchScene pyramid() {
  constexpr int rows = 20;
  BenchScene scene = on_the_ground();
  scene.stays_upright = true;
  const ShapePtr cube = shape_of(box_soup(Vec3::Constant(half_cube)));
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const Vec3 centre(along_row(i, rows - row, 1), 0, static_cast<Real>(row) + half_cube);
      add_body(scene, cube, {centre, Quat::Identity()});
    }
  }
  return scene;
}

BenchScene stacks() {
  constexpr int across = 5, height = 10;
  BenchScene scene = on_the_ground();
  scene.stays_upright = true;
  const ShapePtr cube = shape_of(box_soup(Vec3::Constant(half_cube)));
  for (int x = 0; x < across; ++x) {
    for (int y = 0; y < across; ++y) {
      for (int z = 0; z < height; ++z) {
        const Vec3 centre(along_row(x, across, 2), along_row(y, across, 2),
                          static_cast<Real>(z) + half_cube);
        add_body(scene, cube, {centre, Quat::Identity()});
      }
    }
  }
  return scene;
}

/// A thousand cubes that fall with random orientations.
BenchScene tumbled_cubes() {
  constexpr int across = 10;
  constexpr Real spacing = Real(1.75);
  BenchScene scene = in_a_room(18);
  const ShapePtr cube = shape_of(box_soup(Vec3::Constant(half_cube)));
  Random random(777);
  for (int z = 0; z < across; ++z) {
    for (int x = 0; x < across; ++x) {
      for (int y = 0; y < across; ++y) {
        const Vec3 centre(along_row(x, across, spacing), along_row(y, across, spacing),
                          1 + static_cast<Real>(z) * spacing);
        add_body(scene, cube, {centre, random.orientation()});
      }
    }
  }
  return scene;
}

constexpr NamedScene scenes[] = {
    {"S1", "pyramid of 20 rows: 210 cubes", pyramid},
    {"S2", "25 stacks of 10 cubes", stacks},
    {"S3", "pile of 512 hulls of 32 vertices", [] { return pile_of_hulls(8, 8, 32); }},
    {"S4b", "pile of 256 hulls of 44 vertices", [] { return pile_of_hulls(8, 4, 44); }},
    {"S4", "pile of 256 hulls of 128 vertices", [] { return pile_of_hulls(8, 4, 128); }},
    {"S5", "1,000 cubes that fall in columns", [] { return columns_of_cubes(10); }},
    {"S5b", "1,000 cubes that fall tumbling", tumbled_cubes},
};

}  // namespace

std::span<const NamedScene> compared_scenes() { return scenes; }

BenchScene columns_of_cubes(int across) {
  constexpr int height = 10;
  constexpr Real spacing = Real(1.3);
  BenchScene scene = in_a_room(static_cast<Real>(across) * spacing + 3);
  scene.stays_upright = true;
  const ShapePtr cube = shape_of(box_soup(Vec3::Constant(half_cube)));
  Random random(777);
  for (int z = 0; z < height; ++z) {
    for (int x = 0; x < across; ++x) {
      for (int y = 0; y < across; ++y) {
        const Vec3 tilt_axis = random.unit_vector();
        const Quat tilt(Eigen::AngleAxis<Real>(random.real(0, Real(0.1)), tilt_axis));
        const Real shift_x = random.real(Real(-0.05), Real(0.05));
        const Real shift_y = random.real(Real(-0.05), Real(0.05));
        const Vec3 centre(along_row(x, across, spacing) + shift_x,
                          along_row(y, across, spacing) + shift_y,
                          1 + static_cast<Real>(z) * spacing);
        add_body(scene, cube, {centre, tilt});
      }
    }
  }
  return scene;
}

BenchScene pile_of_hulls(int across, int layers, int vertices) {
  constexpr Real spacing = Real(1.2);
  BenchScene scene = in_a_room(static_cast<Real>(across) * spacing + Real(2.4));
  Random random(12345);
  for (int z = 0; z < layers; ++z) {
    for (int x = 0; x < across; ++x) {
      for (int y = 0; y < across; ++y) {
        const Vec3 centre(along_row(x, across, spacing), along_row(y, across, spacing),
                          1 + static_cast<Real>(z) * spacing);
        add_body(scene, random_hull(vertices, random.bits()), {centre, random.orientation()});
      }
    }
  }
  return scene;
}

BenchScene pile_of_shared_hulls(int across, int layers, int vertices, std::size_t shapes) {
  BenchScene scene = pile_of_hulls(across, layers, vertices);
  std::vector<ShapePtr> shared;
  std::size_t turn = 0;
  for (BodyDef& body : scene.bodies) {
    if (body.kind != BodyKind::Dynamic) continue;
    if (shared.size() < shapes) shared.push_back(body.shape);
    body.shape = shared[turn++ % shapes];
  }
  return scene;
}

BenchScene lone_cubes(int across) {
  BenchScene scene;
  scene.half_width = 2 * static_cast<Real>(across);
  const ShapePtr cube = shape_of(box_soup(Vec3::Constant(half_cube)));
  for (int x = 0; x < across; ++x) {
    for (int y = 0; y < across; ++y) {
      add_body(scene, cube,
               {Vec3(along_row(x, across, 4), along_row(y, across, 4), 0), Quat::Identity()});
    }
  }
  return scene;
}

bool is_box(const ConvexShape& shape) {
  const Real volume_of_bounds = shape.bounds.extent().prod();
  return shape.mesh.vertex_count() == 8 &&
         std::abs(shape.volume - volume_of_bounds) < Real(1e-4) * volume_of_bounds;
}

Vec3 half_extents_of_box(const ConvexShape& shape) { return shape.bounds.extent() / 2; }

bool has_only_boxes(const BenchScene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const BodyDef& body) { return is_box(*body.shape); });
}

}  // namespace cs550::bench
