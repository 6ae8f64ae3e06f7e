#include "cs550/primitives.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "helpers/fixtures.hpp"

namespace cs550::test {
namespace {

struct Solid {
  const char* what;
  TriangleSoup soup;
  Index vertices, merged_faces;
  double volume;
};

TEST(Primitives, HaveTheCountsAndVolumesOfTheSolids) {
  const double hexagon = 1.5 * std::sqrt(3.0);
  const Solid solids[] = {
      {"box", box_soup({1, 2, 3}), 8, 6, 48},
      {"tetrahedron", tetrahedron_soup(3), 4, 4, 4.5},
      {"triangular prism", prism_soup(3, 1, 0.5F), 6, 5, hexagon / 2},
      {"hexagonal prism", prism_soup(6, 1, 1), 12, 8, 2 * hexagon},
      {"square pyramid", pyramid_soup(4, 1, 1), 5, 5, 2.0 / 3},
      {"hexagonal pyramid", pyramid_soup(6, 1, 2), 7, 7, hexagon * 2 / 3},
      // Of an icosahedron in the unit sphere: 5/12·(3 + √5)·a³, a = 4/√(10 + 2√5).
      {"icosahedron", icosphere_soup(0, 1), 12, 20, 2.5361507},
  };
  for (const Solid& solid : solids) {
    const ShapeResult result = make_shape(solid.soup.vertices, solid.soup.triangles);
    ASSERT_TRUE(result) << solid.what << ": " << result.error;
    EXPECT_EQ(result.shape->mesh.vertex_count(), solid.vertices) << solid.what;
    EXPECT_EQ(result.shape->mesh.face_count(), solid.merged_faces) << solid.what;
    EXPECT_NEAR(result.shape->volume, solid.volume, 1e-6 * solid.volume) << solid.what;
  }
}

TEST(Primitives, RefuseLengthsAndCountsThatMakeNoSolid) {
  const Real infinite = std::numeric_limits<Real>::infinity();
  EXPECT_THROW(box_soup({1, -1, 1}), std::invalid_argument);
  EXPECT_THROW(box_soup({1, infinite, 1}), std::invalid_argument);
  EXPECT_THROW(tetrahedron_soup(0), std::invalid_argument);
  EXPECT_THROW(prism_soup(2, 1, 1), std::invalid_argument);
  EXPECT_THROW(prism_soup(1 << 30, 1, 1), std::invalid_argument);
  EXPECT_THROW(prism_soup(6, -1, 1), std::invalid_argument);
  EXPECT_THROW(pyramid_soup(4, 1, 0), std::invalid_argument);
  EXPECT_THROW(icosphere_soup(-1, 1), std::invalid_argument);
  EXPECT_THROW(icosphere_soup(20, 1), std::invalid_argument);
  EXPECT_THROW(icosphere_soup(1, -1), std::invalid_argument);
}

TEST(Primitives, IcosphereVerticesLieOnTheSphere) {
  const TriangleSoup soup = icosphere_soup(3, 2);
  EXPECT_EQ(soup.vertices.size(), 642U);
  EXPECT_EQ(soup.triangles.size(), 1280U);
  for (const Vec3& vertex : soup.vertices) EXPECT_NEAR(vertex.norm(), 2, 1e-6);
}

TEST(Primitives, RandomSpherePointsAreReproducibleAndSpread) {
  const std::vector<Vec3> points = random_sphere_points(10000, 7);
  EXPECT_EQ(points, random_sphere_points(10000, 7));
  EXPECT_NE(points, random_sphere_points(10000, 8));
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) {
    EXPECT_NEAR(point.norm(), 1, 1e-6);
    mean += point / 10000;
  }
  // Each coordinate has variance 1/3: the mean's is 1/30000; 5 standard deviations.
  EXPECT_LE(mean.cwiseAbs().maxCoeff(), 0.029F);
}

}  // namespace
}  // namespace cs550::test
