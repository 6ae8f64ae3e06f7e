// L2.3: the loops around faces and vertices.
#include <cs550/graded_test.hpp>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

std::vector<TriangleSoup> sound_soups() {
  return {tetrahedron_soup(1), cut_from_corners(box(Vec3(1, 2, 3))),
          cut_from_corners(dodecahedron()), prism_soup(7, 1, 2), icosphere_soup(2, 1)};
}

GRADED_TEST(Lab2, FaceLoopsFollowTheTriangles, 3, "L2.3") {
  Story story(
      "Face f is triangle f: its half-edges run from vertex to vertex as the triangle does");
  story.likely("next of the third half-edge is the first: count modulo three")
      .likely("prev is the inverse of next")
      .likely("sorting the sides changes their places: remember to which corner each belongs");
  for (const TriangleSoup& soup : sound_soups()) {
    Story here = story;
    here.given("triangles", soup.triangles.size());
    const HalfEdgeMesh mesh = require_mesh(soup, here);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Triangle& triangle = soup.triangles[f];
      here.given("face", f);
      Index e = mesh.face(f).edge;
      const auto first = std::find(triangle.begin(), triangle.end(), mesh.origin(e));
      require(here.expect("where the face's half-edge comes from", first != triangle.end(),
                          "vertex " + std::to_string(mesh.origin(e)),
                          "a corner of its triangle: " + Story::show(triangle)));
      const auto start = first - triangle.begin();
      for (std::size_t i = 0; i < 3; ++i) {
        const HalfEdge& edge = mesh.edge(e);
        require(here.expect_equal("where the half-edge points to", edge.vertex,
                                  triangle[(start + i + 1) % 3]));
        require(here.expect_equal("the face of the half-edge", edge.face, f));
        require(here.expect_equal("prev of next", mesh.edge(edge.next).prev, e));
        e = edge.next;
      }
      require(here.expect_equal("the half-edge after three times next", e, mesh.face(f).edge));
    }
  }
}

GRADED_TEST(Lab2, EveryVertexLeadsToItsNeighbours, 2, "L2.3") {
  Story story("From a vertex, twin and next lead to every neighbour once");
  story.likely("vertex_edge holds a half-edge that leaves the vertex, not one that points to it");
  for (const TriangleSoup& soup : sound_soups()) {
    const HalfEdgeMesh mesh = require_mesh(soup, story);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::set<Index> expected;
      for (const Triangle& triangle : soup.triangles) {
        if (std::count(triangle.begin(), triangle.end(), v) == 0) continue;
        for (const Index other : triangle) {
          if (other != v) expected.insert(other);
        }
      }
      Story here = story;
      here.given("triangles", soup.triangles.size()).given("vertex", v);
      require(
          here.expect_equal("where its half-edge comes from", mesh.origin(mesh.vertex_edge[v]), v));
      std::set<Index> got;
      std::size_t steps = 0;
      for (const Index e : vertex_edges(mesh, v)) {
        got.insert(mesh.edge(e).vertex);
        if (++steps > expected.size()) break;
      }
      require(here.expect_equal("half-edges that leave it", steps, expected.size()));
      require(here.expect("the vertices that they point to", got == expected, Story::show(got),
                          "its neighbours " + Story::show(expected)));
    }
    Story here = story;
    here.given("triangles", soup.triangles.size());
    require(expect_sound_links(here, mesh, soup));
  }
}

}  // namespace
}  // namespace cs550::test
