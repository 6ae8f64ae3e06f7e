#include <gtest/gtest.h>

#include "cs550/half_edge_mesh.hpp"
#include "cs550/primitives.hpp"
#include "helpers/fixtures.hpp"
#include "serialisation/wire.hpp"

namespace cs550::test {
namespace {

TEST(Serialisation, Lab2IsCalledAcrossAWire) {
  const TriangleSoup soup = prism_soup(6, 1, 2);
  const HalfEdgeMesh mesh = fixture_mesh("triangulated_cube");
  const std::vector<Triangle> open(soup.triangles.begin() + 1, soup.triangles.end());
  EXPECT_SAME_ACROSS_WIRE(build_half_edge_mesh, soup.vertices, soup.triangles);
  EXPECT_SAME_ACROSS_WIRE(build_half_edge_mesh, soup.vertices, open);
  EXPECT_SAME_ACROSS_WIRE(polygon_plane, soup.vertices);
  EXPECT_SAME_ACROSS_WIRE(face_plane, NamedMesh(mesh), 3);
  EXPECT_SAME_ACROSS_WIRE(merge_coplanar_faces, NamedMesh(mesh), coplanar_tolerance);
}

TEST(Serialisation, NoMemberOfLab2IsForgotten) {
  EXPECT_EVERY_WORD_SENT(Plane);
  EXPECT_EVERY_WORD_SENT(HalfEdge);
  EXPECT_EVERY_WORD_SENT(Face);
  EXPECT_EVERY_WORD_SENT(MeshIssue);
}

}  // namespace
}  // namespace cs550::test
