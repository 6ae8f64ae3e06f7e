#include <gtest/gtest.h>

#include <algorithm>

#include "cs550/mesh_validation.hpp"
#include "helpers/fixtures.hpp"

namespace cs550::test {
namespace {

/// Removes an edge as specified for merge_coplanar_faces(). The two loops become that of the left
/// face, and the right face and both half-edges are marked.
void remove_edge(HalfEdgeMesh& mesh, std::size_t e) {
  const HalfEdge left = mesh.edges[e], right = mesh.edges[e ^ 1];
  for (Index i = right.next; i != left.twin; i = mesh.edge(i).next) {
    mesh.edges[i].face = left.face;
  }
  const auto tie = [&](Index in, Index out) {
    mesh.edges[in].next = out;
    mesh.edges[out].prev = in;
  };
  tie(left.prev, right.next);
  tie(right.prev, left.next);
  mesh.faces[left.face].edge = left.next;
  mesh.faces[right.face].edge = no_index;
  mesh.edges[e].face = mesh.edges[e ^ 1].face = no_index;
}

/// The lowest half-edge of a cube of triangles that is the diagonal of a side.
std::size_t diagonal(const HalfEdgeMesh& mesh) {
  std::size_t e = 0;
  const auto normal = [&](std::size_t i) { return mesh.face(mesh.edges[i].face).plane.normal; };
  while (normal(e).dot(normal(e ^ 1)) < Real(0.9)) ++e;
  return e;
}

TEST(WithoutRemoved, KeepsEverythingThatIsNotMarked) {
  const HalfEdgeMesh cube = fixture_mesh("triangulated_cube");
  const HalfEdgeMesh same = without_removed(cube);
  EXPECT_FALSE(validate(same));
  EXPECT_EQ(same.vertices, cube.vertices);
  ASSERT_EQ(same.edge_count(), cube.edge_count());
  for (Index e = 0; e < cube.edge_count(); ++e) {
    EXPECT_EQ(same.edge(e).vertex, cube.edge(e).vertex);
    EXPECT_EQ(same.edge(e).next, cube.edge(e).next);
    EXPECT_EQ(same.edge(e).face, cube.edge(e).face);
  }
}

TEST(WithoutRemoved, GivesASoundMeshOfWhatIsLeft) {
  HalfEdgeMesh mesh = fixture_mesh("triangulated_cube");
  remove_edge(mesh, diagonal(mesh));
  const HalfEdgeMesh result = without_removed(mesh);
  const auto defect = validate(result);
  EXPECT_FALSE(defect) << defect->sentence;
  EXPECT_EQ(result.face_count(), 11);
  EXPECT_EQ(result.edge_count(), 34);
  EXPECT_EQ(result.vertex_count(), 8);
}

TEST(WithoutRemoved, DropsVerticesThatNothingPointsTo) {
  HalfEdgeMesh mesh = fixture_mesh("cube");
  mesh.vertices.insert(mesh.vertices.begin() + 3, Vec3::Zero());
  mesh.vertex_edge.insert(mesh.vertex_edge.begin() + 3, no_index);
  for (HalfEdge& edge : mesh.edges) edge.vertex += edge.vertex >= 3 ? 1 : 0;
  const HalfEdgeMesh result = without_removed(mesh);
  EXPECT_FALSE(validate(result));
  EXPECT_EQ(result.vertices, fixture_mesh("cube").vertices);
}

/// Links that a student forgot are reported by validate() and must not cause a crash.
TEST(WithoutRemoved, LeavesLinksToRemovedElementsEmpty) {
  HalfEdgeMesh mesh = fixture_mesh("cube");
  const HalfEdge gone = mesh.edge(6);
  mesh.edges[6].face = mesh.edges[7].face = no_index;
  const HalfEdgeMesh result = without_removed(mesh);
  EXPECT_EQ(result.edge_count(), mesh.edge_count() - 2);
  const auto loose = std::count_if(
      result.edges.begin(), result.edges.end(),
      [](const HalfEdge& edge) { return edge.next == no_index || edge.prev == no_index; });
  EXPECT_EQ(loose, 4) << "the neighbours of both halves";
  EXPECT_TRUE(validate(result));

  mesh.edges[7].face = gone.face;
  EXPECT_EQ(without_removed(mesh).edge_count(), mesh.edge_count()) << "half an edge cannot go";
  mesh.edges[7] = {.vertex = 99, .next = -5, .prev = 1000, .twin = 6, .face = 77};
  EXPECT_TRUE(validate(without_removed(mesh)));
}

}  // namespace
}  // namespace cs550::test
