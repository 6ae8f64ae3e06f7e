#include <gtest/gtest.h>

#include "cs550/half_edge_mesh.hpp"
#include "cs550/primitives.hpp"

using namespace cs550;

TEST(Mesh, OfABoxFollowsEuler) {
  const TriangleSoup box = box_soup(Vec3(1, 2, 3));
  const MeshBuild built = build_half_edge_mesh(box.vertices, box.triangles);
  ASSERT_FALSE(built.issue) << describe(built.issue);
  const HalfEdgeMesh& mesh = built.mesh;
  EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() / 2 + mesh.face_count(), 2);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    EXPECT_EQ(mesh.edge(e).twin, e ^ 1);
    EXPECT_EQ(mesh.edge(mesh.edge(e).next).prev, e);
  }
  const HalfEdgeMesh merged = merge_coplanar_faces(mesh);
  EXPECT_EQ(merged.face_count(), 6);
  EXPECT_EQ(merged.edge_count(), 24);
}

TEST(Mesh, RefusesAHole) {
  TriangleSoup box = box_soup(Vec3(1, 2, 3));
  box.triangles.pop_back();
  EXPECT_EQ(build_half_edge_mesh(box.vertices, box.triangles).issue.error, MeshError::OpenEdge);
}

TEST(Plane, OfASquareFacesItsCounterClockwiseSide) {
  const std::vector<Vec3> corners{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}};
  const Plane plane = polygon_plane(corners);
  EXPECT_NEAR(plane.normal.z(), 1, 1e-6);
  EXPECT_NEAR(plane.offset, 2, 1e-6);
}
