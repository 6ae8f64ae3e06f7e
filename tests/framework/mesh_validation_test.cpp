#include "cs550/mesh_validation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cs550/convex_shape.hpp"
#include "cs550/primitives.hpp"
#include "helpers/fixtures.hpp"

namespace cs550::test {
namespace {

/// Violates one invariant of a mesh. Each test states which element must be reported.
class BrokenMesh : public testing::Test {
 protected:
  HalfEdge& edge(Index e) { return mesh.edges[e]; }
  Face& face(Index f) { return mesh.faces[f]; }
  Vec3& vertex(Index v) { return mesh.vertices[v]; }

  void expect_defect(MeshElement element, Index index, const std::string& words) {
    const auto defect = validate(mesh);
    ASSERT_TRUE(defect) << "nothing found";
    EXPECT_EQ(defect->element, element) << defect->sentence;
    EXPECT_EQ(defect->index, index) << defect->sentence;
    EXPECT_NE(defect->sentence.find(words), std::string::npos) << defect->sentence;
  }

  /// Appends a copy of the mesh with shifted indices.
  void add_copy_at(const Vec3& shift) {
    const HalfEdgeMesh copy = mesh;
    for (const Vec3& v : copy.vertices) mesh.vertices.push_back(v + shift);
    for (Index e : copy.vertex_edge) mesh.vertex_edge.push_back(e + copy.edge_count());
    for (HalfEdge e : copy.edges) {
      mesh.edges.push_back({e.vertex + copy.vertex_count(), e.next + copy.edge_count(),
                            e.prev + copy.edge_count(), e.twin + copy.edge_count(),
                            e.face + copy.face_count()});
    }
    for (Face f : copy.faces) {
      f.edge += copy.edge_count();
      f.plane.offset += f.plane.normal.dot(shift);
      mesh.faces.push_back(f);
    }
  }

  HalfEdgeMesh mesh = fixture_mesh("cube");
};

TEST_F(BrokenMesh, TheWholeOneIsValid) { EXPECT_FALSE(validate(mesh)); }

TEST_F(BrokenMesh, Empty) {
  mesh = {};
  expect_defect(MeshElement::Mesh, no_index, "no vertices");
}

TEST_F(BrokenMesh, OddNumberOfHalfEdges) {
  mesh.edges.pop_back();
  expect_defect(MeshElement::Mesh, no_index, "odd");
}

TEST_F(BrokenMesh, VertexEdgeOfAnotherSize) {
  mesh.vertex_edge.pop_back();
  expect_defect(MeshElement::Mesh, no_index, "7 entries for 8 vertices");
}

TEST_F(BrokenMesh, IndexOutOfRange) {
  const HalfEdgeMesh whole = mesh;
  edge(5).vertex = 8;
  expect_defect(MeshElement::HalfEdge, 5, "its vertex 8 does not exist");
  mesh = whole;
  edge(5).next = 24;
  expect_defect(MeshElement::HalfEdge, 5, "its next 24");
  mesh = whole;
  edge(5).prev = no_index;
  expect_defect(MeshElement::HalfEdge, 5, "its prev -1");
  mesh = whole;
  edge(5).twin = 99;
  expect_defect(MeshElement::HalfEdge, 5, "its twin 99");
  mesh = whole;
  edge(5).face = 6;
  expect_defect(MeshElement::HalfEdge, 5, "its face 6");
  mesh = whole;
  face(2).edge = 24;
  expect_defect(MeshElement::Face, 2, "its half-edge 24");
  mesh = whole;
  mesh.vertex_edge[3] = no_index;
  expect_defect(MeshElement::Vertex, 3, "its half-edge -1");
}

TEST_F(BrokenMesh, VertexThatIsNotANumber) {
  vertex(4).y() = NAN;
  expect_defect(MeshElement::Vertex, 4, "not a number");
}

TEST_F(BrokenMesh, TwinThatDoesNotPointBack) {
  edge(12).twin = 3;
  expect_defect(MeshElement::HalfEdge, 12, "its twin 3 does not point back to it");
}

TEST_F(BrokenMesh, TwinsThatAreNotNeighbours) {
  // Half-edges 1 and 2 are swapped in the array, and all links are updated.
  const auto renamed = [](Index e) { return e == 1 ? 2 : e == 2 ? 1 : e; };
  std::swap(edge(1), edge(2));
  for (HalfEdge& e : mesh.edges) {
    e.next = renamed(e.next);
    e.prev = renamed(e.prev);
    e.twin = renamed(e.twin);
  }
  for (Index& e : mesh.vertex_edge) e = renamed(e);
  for (Face& f : mesh.faces) f.edge = renamed(f.edge);
  expect_defect(MeshElement::HalfEdge, 0, "its twin is 2, not its neighbour 1");
}

// All faces of a roof stay planar and convex if its ridge becomes a point. Hill climbing would stop there.
TEST_F(BrokenMesh, EdgeWithoutALength) {
  const std::vector<Vec3> roof = {{-1, -1, 0}, {1, -1, 0},    {1, 1, 0},
                                  {-1, 1, 0},  {0, -0.5F, 1}, {0, 0.5F, 1}};
  const SoupResult hull = convex_hull(roof);
  mesh = make_shape(hull.soup.vertices, hull.soup.triangles).shape->mesh;
  ASSERT_FALSE(validate(mesh));
  for (Vec3& v : mesh.vertices) {
    if (v.z() > 0) v.y() = 0;
  }
  for (Index f = 0; f < mesh.face_count(); ++f) face(f).plane = face_plane(mesh, f);
  const auto defect = validate(mesh);
  ASSERT_TRUE(defect);
  EXPECT_NE(defect->sentence.find("ends are in one place"), std::string::npos) << defect->sentence;
}

TEST_F(BrokenMesh, TwinsInTheSameDirection) {
  edge(0).vertex = edge(1).vertex;
  expect_defect(MeshElement::HalfEdge, 0, "point to the same vertex");
}

TEST_F(BrokenMesh, PrevThatIsNotTheInverseOfNext) {
  edge(edge(6).next).prev = edge(6).prev;
  expect_defect(MeshElement::HalfEdge, 6, "the prev of its next");
}

TEST_F(BrokenMesh, LoopThroughTwoFaces) {
  edge(0).face = (edge(0).face + 1) % 6;
  const Index first = std::min(0, edge(0).prev);
  expect_defect(MeshElement::HalfEdge, first, "and its next");
}

TEST_F(BrokenMesh, EdgeThatDoesNotStartWhereTheLastOneEnds) {
  edge(0).vertex = edge(edge(0).next).vertex;
  // Half-edge 1 now leaves that vertex too and is found after half-edge 0.
  expect_defect(MeshElement::HalfEdge, 0, "leaves vertex");
}

TEST_F(BrokenMesh, FaceWhoseEdgeBelongsToAnother) {
  face(3).edge = face(4).edge;
  expect_defect(MeshElement::Face, 3, "belongs to face 4");
}

TEST_F(BrokenMesh, FaceOfTwoEdges) {
  // Two triangles back to back. One edge has been split into a face of two edges.
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.vertex_edge = {0, 1, 4};
  mesh.edges = {{1, 2, 4, 1, 0}, {0, 6, 6, 0, 1}, {2, 4, 0, 3, 0}, {1, 7, 5, 2, 2},
                {0, 0, 2, 5, 0}, {2, 3, 7, 4, 2}, {1, 1, 1, 7, 1}, {0, 5, 3, 6, 2}};
  mesh.faces = {{0, {}}, {1, {}}, {3, {}}};
  expect_defect(MeshElement::Face, 1, "only 2 edges");
}

TEST_F(BrokenMesh, FaceOfTwoLoops) {
  const Index other = 5;
  for (Index e : face_edges(mesh, other)) edge(e).face = 0;
  mesh.faces.pop_back();
  expect_defect(MeshElement::Face, 0, "more than one loop");
}

TEST_F(BrokenMesh, VertexEdgeThatLeavesAnother) {
  mesh.vertex_edge[2] = mesh.vertex_edge[1];
  expect_defect(MeshElement::Vertex, 2, "leaves vertex 1");
}

TEST_F(BrokenMesh, VertexOfDegreeTwo) {
  // A vertex in the middle of edge 0–1.
  const Index middle = mesh.vertex_count(), e = mesh.edge_count();
  const HalfEdge ahead = edge(0), back = edge(1);
  mesh.vertices.push_back((vertex(ahead.vertex) + vertex(back.vertex)) / 2);
  mesh.vertex_edge.push_back(e);
  mesh.edges.push_back({ahead.vertex, ahead.next, 0, e + 1, ahead.face});
  mesh.edges.push_back({middle, 1, back.prev, e, back.face});
  edge(ahead.next).prev = e;
  edge(back.prev).next = e + 1;
  edge(0).vertex = middle;
  edge(0).next = e;
  edge(1).prev = e + 1;
  mesh.vertex_edge[ahead.vertex] = e + 1;
  expect_defect(MeshElement::Vertex, middle, "only 2 edges");
}

TEST_F(BrokenMesh, SurfacesThatTouchInAVertex) {
  add_copy_at({5, 0, 0});
  // Vertex 8 of the copy becomes vertex 0, and the last vertex is renumbered to 8.
  const Index last = mesh.vertex_count() - 1;
  for (HalfEdge& e : mesh.edges) {
    if (e.vertex == 8) e.vertex = 0;
    if (e.vertex == last) e.vertex = 8;
  }
  mesh.vertices[8] = mesh.vertices.back();
  mesh.vertex_edge[8] = mesh.vertex_edge.back();
  mesh.vertices.pop_back();
  mesh.vertex_edge.pop_back();
  expect_defect(MeshElement::Vertex, 0, "touches itself");
}

TEST_F(BrokenMesh, TwoSurfaces) {
  add_copy_at({5, 0, 0});
  expect_defect(MeshElement::Mesh, no_index, "16 − 24 + 12 = 4, not 2");
}

TEST_F(BrokenMesh, NormalThatIsNotUnit) {
  face(1).plane.normal *= 2;
  expect_defect(MeshElement::Face, 1, "length 2");
}

TEST_F(BrokenMesh, NormalThatIsNotANumber) {
  face(1).plane.normal.x() = NAN;
  expect_defect(MeshElement::Face, 1, "length nan");
}

TEST_F(BrokenMesh, FaceThatIsNotPlanar) {
  const Index corner = edge(face(0).edge).vertex;
  vertex(corner) -= 0.01F * face(0).plane.normal;
  expect_defect(MeshElement::Face, 0, "away from its plane");
}

TEST_F(BrokenMesh, PlaneBesideItsFace) {
  face(4).plane.offset += 0.01F;
  expect_defect(MeshElement::Face, 4, "away from its plane");
}

TEST_F(BrokenMesh, InsideOut) {
  for (Vec3& v : mesh.vertices) v.x() = -v.x();
  for (Face& f : mesh.faces) f.plane.normal.x() = -f.plane.normal.x();
  expect_defect(MeshElement::Mesh, no_index, "clockwise");
}

TEST_F(BrokenMesh, FaceWithAReflexCorner) {
  mesh = fixture_mesh("prism6");
  // The upper and lower ends of an edge are moved behind the line through their neighbours.
  for (Vec3& v : mesh.vertices) {
    if (v.x() > 0.9F) v.x() = 0.2F;
  }
  for (Index f = 0; f < mesh.face_count(); ++f) face(f).plane = face_plane(mesh, f);
  const auto defect = validate(mesh);
  ASSERT_TRUE(defect);
  EXPECT_NE(defect->sentence.find("turns inward"), std::string::npos) << defect->sentence;
  EXPECT_GT(std::abs(mesh.face(defect->index).plane.normal.z()), 0.9F) << "an end of the prism";
}

TEST_F(BrokenMesh, MeshThatIsNotConvex) {
  mesh = fixture_mesh("twin_peaks");
  const auto defect = validate(mesh);
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->element, MeshElement::Face);
  EXPECT_NE(defect->sentence.find("the mesh is not convex"), std::string::npos) << defect->sentence;
}

TEST_F(BrokenMesh, ToleranceIsRelativeToTheSize) {
  for (const Real size : {Real(1e-3), Real(1e3)}) {
    for (const bool is_dented : {false, true}) {
      mesh = fixture_mesh("cube");
      if (is_dented) vertex(0) *= Real(0.999);  // 5e-4 of the size, along each axis
      for (Vec3& v : mesh.vertices) v *= size;
      for (Face& f : mesh.faces) f.plane.offset *= size;
      EXPECT_EQ(validate(mesh).has_value(), is_dented) << size;
      EXPECT_FALSE(validate(mesh, Real(1e-3))) << size;
    }
  }
}

TEST(MeshIssue, DoesNotPrintAnIndexThatWasNotGiven) {
  MeshIssue issue;
  issue.error = MeshError::OpenEdge;
  EXPECT_EQ(describe(issue).find("-1"), std::string::npos) << describe(issue);
  issue.triangle = 3;
  EXPECT_NE(describe(issue).find("triangle 3 only"), std::string::npos) << describe(issue);
}

}  // namespace
}  // namespace cs550::test
