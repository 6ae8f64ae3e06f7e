#include "cs550/convex_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cs550/mesh_io.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/random.hpp"

namespace cs550::test {
namespace {

ShapeResult shape_of(const TriangleSoup& soup) { return make_shape(soup.vertices, soup.triangles); }

TriangleSoup scanned(const std::string& name) {
  const SoupResult result = load_obj(std::string(CS550_ASSETS) + "/meshes/" + name + ".obj");
  EXPECT_EQ(result.error, "");
  return result.soup;
}

void expect_refused(const ShapeResult& result, const std::string& what, const std::string& remedy) {
  EXPECT_EQ(result.shape, nullptr);
  EXPECT_NE(result.error.find(what), std::string::npos) << "'" << result.error << "'";
  EXPECT_NE(result.error.find(remedy), std::string::npos) << "'" << result.error << "'";
}

TEST(ConvexShape, HasItsOriginAtTheCentroidAndKnowsWhereTheOldOneWas) {
  const ShapeResult result = shape_of(tetrahedron_soup(2));
  ASSERT_TRUE(result) << result.error;
  const ConvexShape& shape = *result.shape;
  EXPECT_LE((shape.source_origin - Vec3::Constant(-0.5F)).norm(), 1e-6F);
  EXPECT_LE((shape.mesh.vertex(0) - shape.source_origin).norm(), 1e-6F) << "was the corner at 0";
  EXPECT_NEAR(shape.volume, 8.0 / 6, 1e-6);
}

TEST(ConvexShape, OfABoxIsMeasured) {
  const ShapeResult result = shape_of(box_soup({1, 2, 3}));
  ASSERT_TRUE(result) << result.error;
  const ConvexShape& shape = *result.shape;
  EXPECT_EQ(shape.mesh.face_count(), 6) << "coplanar triangles merged";
  EXPECT_NEAR(shape.volume, 48, 1e-5);
  EXPECT_NEAR(shape.unit_inertia(0, 0), 48.0 / 3 * (4 + 9), 1e-4);
  EXPECT_EQ(shape.bounds.lower, Vec3(-1, -2, -3));
  EXPECT_EQ(shape.bounds.upper, Vec3(1, 2, 3));
  EXPECT_NEAR(shape.radius, std::sqrt(14.0), 1e-6);
  EXPECT_NEAR(shape.inner_radius, 1, 1e-6);
  EXPECT_NEAR(shape.smallest_half_extent, 1, 1e-6);
}

TEST(ConvexShape, HasItsPlanesInBlocksOfFour) {
  const ShapeResult result = shape_of(box_soup({1, 2, 3}));
  ASSERT_TRUE(result) << result.error;
  const std::vector<PlaneBlock>& blocks = result.shape->plane_blocks;
  ASSERT_EQ(blocks.size(), 2U) << "six faces";
  for (std::size_t i = 0; i < 8; ++i) {
    const PlaneBlock& block = blocks[i / 4];
    const Vec3 normal(block.x[i % 4], block.y[i % 4], block.z[i % 4]);
    const Index face = std::min(static_cast<Index>(i), 5);
    EXPECT_EQ(normal, result.shape->mesh.face(face).plane.normal) << "face " << face;
    EXPECT_EQ(block.offset[i % 4], std::abs(normal.dot(Vec3(1, 2, 3))));
  }
}

TEST(ConvexShape, FarFromTheOriginKeepsItsPlanes) {
  HalfEdgeMesh mesh = fixture_mesh("dodecahedron");
  const Vec3 shift(512, -256, 128);
  for (Vec3& vertex : mesh.vertices) vertex += shift;
  for (Face& face : mesh.faces) face.plane.offset += face.plane.normal.dot(shift);
  const ShapeResult result = make_shape(mesh);
  ASSERT_TRUE(result) << result.error;
  const HalfEdgeMesh& moved = result.shape->mesh;
  for (Index f = 0; f < moved.face_count(); ++f) {
    for (Index e : face_edges(moved, f)) {
      // Vertices 600 m away are rounded to 2⁻¹⁴ m at worst.
      EXPECT_NEAR(moved.face(f).plane.distance(moved.vertex(moved.edge(e).vertex)), 0, 1.3e-4);
    }
  }
}

TEST(ConvexShape, WorldBoundsHoldTheBodyAndAreTightForBoxes) {
  Random random(21);
  for (const char* name : {"box_1x2x3", "needle", "dodecahedron", "hull64", "sliver"}) {
    const ShapePtr shape = fixture_shape(name);
    for (int i = 0; i < 100; ++i) {
      const PosedShape body{shape.get(), {random.point_in_box({5, 5, 5}), random.orientation()}};
      const Bounds got = world_bounds(body);
      Bounds exact;
      for (Index v = 0; v < body.mesh().vertex_count(); ++v) exact.include(body.vertex(v));
      EXPECT_TRUE(got.expanded(Real(1e-5)).contains(exact)) << name;
      EXPECT_LE(got.extent().maxCoeff(), 2 * shape->radius + Real(1e-5)) << name;
      const bool is_box = name == std::string("box_1x2x3");
      EXPECT_TRUE(!is_box || exact.expanded(Real(1e-5)).contains(got)) << name;
    }
  }
}

TEST(ConvexShape, OfAThinMeshKeepsItsCorners) {
  const ShapeResult plate = shape_of(box_soup({500, 500, 0.005F}));
  ASSERT_TRUE(plate) << plate.error;
  EXPECT_EQ(plate.shape->mesh.face_count(), 6);
  EXPECT_NEAR(plate.shape->volume, 1e4, 1);
  // The base and the sides enclose 0.1°: a corner that is cut off is near both planes.
  const ShapeResult pyramid = shape_of(pyramid_soup(64, 0.5F, 1e-3F));
  ASSERT_TRUE(pyramid) << pyramid.error;
  EXPECT_EQ(pyramid.shape->mesh.vertex_count(), 65);
}

TEST(ConvexShape, RefusesAMeshAsThinAsTheRoundingOfItsVertices) {
  expect_refused(shape_of(box_soup({0.5F, 0.5F, 1e-7F})), "too thin", "make it thicker");
}

TEST(ConvexShape, TheRawTeapotIsRefusedAsOpen) {
  const TriangleSoup teapot = scanned("teapot");
  EXPECT_EQ(build_half_edge_mesh(teapot.vertices, teapot.triangles).issue.error,
            MeshError::OpenEdge);
  expect_refused(shape_of(teapot), "the surface is open", "close the hole");
}

TEST(ConvexShape, TheRawBunnyIsRefusedAsNotConvex) {
  const TriangleSoup bunny = scanned("bunny");
  EXPECT_EQ(build_half_edge_mesh(bunny.vertices, bunny.triangles).issue.error, MeshError::None)
      << "it is closed";
  expect_refused(shape_of(bunny), "not convex", "use the convex hull");
}

TEST(ConvexShape, RefusesAFaceOfMoreVerticesThanClippingHolds) {
  EXPECT_TRUE(shape_of(prism_soup(128, 1, 1))) << shape_of(prism_soup(128, 1, 1)).error;
  expect_refused(shape_of(prism_soup(129, 1, 1)), "129 vertices", "at most 128");
}

TEST(ConvexShape, RefusesMoreEdgesThanFeatureIdsHold) {
  // 30·4ⁿ edges: 7,680 and 30,720.
  const TriangleSoup fine = icosphere_soup(4, 1);
  const MeshBuild at_most = build_half_edge_mesh(fine.vertices, fine.triangles);
  EXPECT_TRUE(make_shape(at_most.mesh)) << make_shape(at_most.mesh).error;
  const TriangleSoup finer = icosphere_soup(5, 1);
  const MeshBuild too_many = build_half_edge_mesh(finer.vertices, finer.triangles);
  expect_refused(make_shape(too_many.mesh), "30720 edges", "take fewer points");
}

TEST(ConvexShape, RefusesBrokenTrianglesWithTheirNumbers) {
  TriangleSoup soup = box_soup({1, 1, 1});
  soup.triangles.pop_back();
  expect_refused(shape_of(soup), "triangle", "close the hole");
  soup = box_soup({1, 1, 1});
  for (Triangle& triangle : soup.triangles) std::swap(triangle[0], triangle[1]);
  expect_refused(shape_of(soup), "clockwise", "reverse all");
}

}  // namespace
}  // namespace cs550::test
