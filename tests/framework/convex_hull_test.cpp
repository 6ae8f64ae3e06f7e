#include <gtest/gtest.h>

#include <thread>

#include "cs550/mesh_io.hpp"
#include "cs550/mesh_validation.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

/// The result for a cloud: a shape, or an error message.
ShapeResult hull_shape(const std::vector<Vec3>& points) {
  const SoupResult hull = convex_hull(points);
  if (!hull.error.empty()) return {nullptr, hull.error};
  return make_shape(hull.soup.vertices, hull.soup.triangles);
}

std::vector<Vec3> grid(int x_count, int y_count, int z_count) {
  std::vector<Vec3> points;
  for (int x = 0; x < x_count; ++x) {
    for (int y = 0; y < y_count; ++y) {
      for (int z = 0; z < z_count; ++z) {
        points.emplace_back(static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z));
      }
    }
  }
  return points;
}

void expect_refused(const std::vector<Vec3>& points, const std::string& words) {
  const SoupResult result = convex_hull(points);
  EXPECT_TRUE(result.soup.vertices.empty());
  EXPECT_NE(result.error.find(words), std::string::npos) << "'" << result.error << "'";
}

/// One face is a sliver. Without it three points are left, on which qhull ends the process.
TEST(ConvexHull, OfATetrahedronThatIsASliverIsRefused) {
  expect_refused({{0, 0, 0}, {1, 0, 0}, {0.5F, 5e-5F, 0}, {0.5F, 0, 1}}, "too narrow");
}

/// The sides of a plate of this thickness are slivers: a hull without them lacks corners.
TEST(ConvexHull, OfPlatesAndRodsHasAllCornersOrIsRefused) {
  for (const Real half : {Real(1e-2), Real(1e-3), Real(2e-4), Real(1e-4)}) {
    for (const Vec3& half_extents : {Vec3(0.5F, 0.5F, half), Vec3(0.5F, half, half)}) {
      const std::vector<Vec3> corners = box_soup(half_extents).vertices;
      EXPECT_EQ(convex_hull(corners).soup.vertices, corners) << half;
    }
  }
  for (const Real half : {Real(2.5e-5), Real(1e-5)}) {
    expect_refused(box_soup({0.5F, 0.5F, half}).vertices, "too narrow");
    expect_refused(box_soup({0.5F, half, half}).vertices, "too narrow");
  }
  expect_refused(box_soup({0.5F, 0.5F, 4e-6F}).vertices, "lie in one plane");
}

/// Some of their sides are slivers, although their thickness is more than that of a plate that is refused.
TEST(ConvexHull, OfRodsOfManySidesAndOfWedgesHasAllCornersOrIsRefused) {
  std::vector<std::vector<Vec3>> clouds = {{{-0.5F, -0.5F, 0},
                                            {-0.5F, 0.5F, 0},
                                            {0.5F, -0.5F, 0},
                                            {0.5F, 0.5F, 0},
                                            {-0.5F, -0.5F, 1e-3F},
                                            {-0.5F, 0.5F, 1e-3F},
                                            {0.5F, -0.5F, 9e-5F},
                                            {0.5F, 0.5F, 9e-5F}}};
  for (int sides = 13; sides <= 32; ++sides) {
    for (const Real radius : {Real(2e-4), Real(2.1e-4), Real(2.3e-4), Real(2.5e-4)}) {
      clouds.push_back(prism_soup(sides, radius, 0.5F).vertices);
    }
  }
  for (const std::vector<Vec3>& corners : clouds) {
    SCOPED_TRACE(std::to_string(corners.size()) + " corners");
    const SoupResult result = convex_hull(corners);
    if (result.error.empty()) {
      EXPECT_EQ(result.soup.vertices, corners);
    } else {
      expect_refused(corners, "too narrow");
    }
  }
  const std::vector<Vec3> wide = prism_soup(32, 0.0006F, 0.5F).vertices;
  EXPECT_EQ(convex_hull(wide).soup.vertices, wide);
}

/// Without the point the plate is shorter by 1/50 of its thickness, as thicker ones are.
TEST(ConvexHull, OfAPlateDropsAPointThatMakesSliversBesideAnEdge) {
  const std::vector<Vec3> corners = box_soup({0.5F, 0.5F, 0.0025F}).vertices;
  std::vector<Vec3> points = corners;
  points.emplace_back(0, 0.50009F, 0.0025F);
  const SoupResult result = convex_hull(points);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.soup.vertices, corners);
}

TEST(ConvexHull, OfACubeDropsWhatIsInsideAndKeepsTheOrder) {
  std::vector<Vec3> points = {Vec3::Zero(), {0.2F, 0.1F, 0}};
  const std::vector<Vec3> corners = box_soup(Vec3::Ones()).vertices;
  points.insert(points.end(), corners.begin(), corners.end());
  Random random(11);
  for (int i = 0; i < 100; ++i) points.push_back(random.point_in_box(Vec3::Constant(0.9F)));
  const SoupResult result = convex_hull(points);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.soup.vertices, corners);
  EXPECT_EQ(result.soup.triangles.size(), 12U);
}

TEST(ConvexHull, OfAGridHasEightCorners) {
  const ShapeResult result = hull_shape(grid(4, 3, 5));
  ASSERT_TRUE(result) << result.error;
  EXPECT_EQ(result.shape->mesh.vertex_count(), 8);
  EXPECT_EQ(result.shape->mesh.face_count(), 6);
  EXPECT_NEAR(result.shape->volume, 3 * 2 * 4, 1e-5);
}

TEST(ConvexHull, OfTurnedGridsIsValidAlthoughTheirPointsAreNoLongerCollinear) {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    const Quat q = random.orientation();
    const Real size = std::pow(Real(10), random.real(-3, 3));
    const Vec3 shift = random.point_in_box(Vec3::Constant(20));
    std::vector<Vec3> points = grid(5, 4, 3);
    for (Vec3& point : points) point = size * (q * point + shift);
    const ShapeResult result = hull_shape(points);
    ASSERT_TRUE(result) << "case " << i << ": " << result.error;
    // Vertices are rounded to 2⁻²⁴ of about 30 m: 1e-5 on 2 m at most.
    EXPECT_NEAR(result.shape->volume / (size * size * size), 4 * 3 * 2, 1e-3) << "case " << i;
  }
}

TEST(ConvexHull, OfNoisyGridsIsValid) {
  Random random(13);
  for (int i = 0; i < 200; ++i) {
    const Real noise = std::pow(Real(10), random.real(-8, -2));
    std::vector<Vec3> points = grid(4, 4, 4);
    for (Vec3& point : points) point += random.point_in_box(Vec3::Constant(noise));
    const ShapeResult result = hull_shape(points);
    ASSERT_TRUE(result) << "noise " << noise << ": " << result.error;
    // Every face moves by the noise, or by a sliver's height of 1e-4 of its edges, at most.
    EXPECT_NEAR(result.shape->volume, 27, 54 * (noise + 3e-4)) << "noise " << noise;
  }
}

TEST(ConvexHull, OfRandomPointsOnASphereHasThemAll) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec3> points = random_sphere_points(100, seed);
    EXPECT_EQ(convex_hull(points).soup.vertices, points) << "seed " << seed;
  }
}

TEST(ConvexHull, HoldsAllPointsOfRandomClouds) {
  Random random(14);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3> points(60);
    for (Vec3& point : points) point = random.point_in_box({1, 2, 3});
    const ShapeResult result = hull_shape(points);
    ASSERT_TRUE(result) << result.error;
    for (const Face& face : result.shape->mesh.faces) {
      for (const Vec3& point : points) {
        const Vec3 local = point + result.shape->source_origin;
        EXPECT_LE(face.plane.distance(local), 6e-5F) << "merging may move a face by 1e-5 of 6 m";
      }
    }
  }
}

TEST(ConvexHull, IsTheSameInEveryThread) {
  const std::vector<Vec3> points = random_sphere_points(400, 15);
  const TriangleSoup expected = convex_hull(points).soup;
  std::vector<TriangleSoup> soups(4);
  std::vector<std::thread> threads;
  threads.reserve(soups.size());
  for (TriangleSoup& soup : soups) {
    threads.emplace_back([&] {
      for (int i = 0; i < 10; ++i) soup = convex_hull(points).soup;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const TriangleSoup& soup : soups) EXPECT_EQ(soup.triangles, expected.triangles);
}

TEST(ConvexHull, RefusesFewerThanFourPoints) {
  expect_refused({}, "four");
  expect_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "there are 3");
}

TEST(ConvexHull, RefusesPointsInAPlane) {
  expect_refused(std::vector<Vec3>(10, Vec3(1, 2, 3)), "one plane");
  expect_refused(grid(9, 1, 1), "one plane");
  expect_refused(grid(3, 3, 1), "one plane");
  // Turned and far away, rounding makes them a very flat solid.
  const Quat q = rotation_exp({0.4F, 0.5F, 0.6F});
  std::vector<Vec3> points = grid(5, 5, 1);
  for (Vec3& point : points) point = q * point + Vec3(30, 20, 10);
  expect_refused(points, "one plane");
}

/// Two places, however often they occur: the normal of a plane through them is rounding.
TEST(ConvexHull, RefusesPointsInALine) {
  Random random(16);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random.point_in_box(Vec3::Constant(3));
    const Vec3 b = random.point_in_box(Vec3::Constant(3));
    expect_refused({a, b, b, b, b, a}, "one plane");
  }
}

TEST(ConvexHull, RefusesWhatIsNotFiniteByItsNumber) {
  std::vector<Vec3> points = grid(2, 2, 2);
  points[5].z() = NAN;
  expect_refused(points, "point 5");
  points[5].z() = 0;
  points[3].x() = HUGE_VALF;
  expect_refused(points, "point 3");
}

/// 1 cm at 100 km, where floats are 8 mm apart: the hull would be another one, without a word.
TEST(ConvexHull, RefusesPointsTooFarFromTheOriginForTheirSize) {
  std::vector<Vec3> points = grid(2, 2, 2);
  for (Vec3& point : points) point = Real(0.01) * point + Vec3(100000, 0, 0);
  expect_refused(points, "too far from the origin; the points span");
  for (Vec3& point : points) point -= Vec3(99990, 0, 0);
  EXPECT_EQ(convex_hull(points).error, "");
}

TEST(ConvexHull, OfScannedMeshesIsValid) {
  for (const char* name : {"bunny", "teapot"}) {
    const SoupResult scan = load_obj(std::string(CS550_ASSETS) + "/meshes/" + name + ".obj");
    ASSERT_EQ(scan.error, "");
    const ShapeResult result = hull_shape(scan.soup.vertices);
    ASSERT_TRUE(result) << name << ": " << result.error;
    EXPECT_FALSE(validate(result.shape->mesh)) << name;
    EXPECT_GT(result.shape->mesh.face_count(), 100) << name;
  }
}

}  // namespace
}  // namespace cs550::test
