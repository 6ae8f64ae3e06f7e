// L2.7 and L2.8: straight vertices, reflex vertices, and chains of shared edges.
#include <cs550/graded_test.hpp>

#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

/// A solid that was cut into triangles, and the elements that it has.
struct Cut {
  const char* name;
  TriangleSoup soup;
  Index vertices, edges, faces;
};

/// Checks that merging undoes the cuts.
void require_solid_again(const Story& story, const Cut& cut) {
  Story here = story;
  here.given(cut.name).given("triangles", cut.soup.triangles.size());
  const HalfEdgeMesh built = require_mesh(cut.soup, here);
  const HalfEdgeMesh mesh = merge_coplanar_faces(built);
  here.picture([&] { return merge_picture(built, mesh); });
  require(expect_counts(here, mesh, cut.vertices, cut.edges, cut.faces));
  require(expect_valid(here, mesh));
  here.expect_near("volume", volume(mesh), volume(built), 1e-5 * volume(built), "m³");
  // The corners of the solids are first in the lists, and their order is kept.
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    here.expect_near("vertex " + std::to_string(v), mesh.vertex(v), cut.soup.vertices[v], 0, "m");
  }
}

/// Its sides rise by 0.11°, and two neighbours may become one face. The corner between them is then left with two edges.
/// It lies within the slack of both planes, but 2.4 mm beside the line through its neighbours: 240 times the slack.
void require_corners_of_a_flat_pyramid(Story story) {
  story.given("a pyramid 1 mm high over a regular 64-gon of radius 0.5 m")
      .likely(
          "where two faces enclose a small angle, a corner is near both planes: measure how far it "
          "is from the line through its neighbours");
  const HalfEdgeMesh built = require_mesh(pyramid_soup(64, Real(0.5), Real(1e-3)), story);
  const HalfEdgeMesh mesh = merge_coplanar_faces(built);
  require(story.expect_equal("vertices", mesh.vertex_count(), 65));
  require(story.expect_at_most("faces", mesh.face_count(), 65));
  require(expect_valid(story, mesh));
  // A third of base times height, the base ½·n·r²·sin(2π/n). The slack is 1 % of the height.
  const double exact = 0.5 * 64 * 0.25 * std::sin(2 * M_PI / 64) * 1e-3 / 3;
  require(story.expect_near("volume", volume(mesh), exact, 0.01 * exact, "m³"));
}

GRADED_TEST(Lab2, StraightVerticesLeaveBothFaces, 4, "L2.7") {
  require_linked_merge();
  Story story("A vertex in the middle of an edge is removed once only two faces share it");
  story.likely(
      "a vertex in the middle of a straight edge is left with two edges: it goes, from the loops "
      "of both faces");
  const TriangleSoup cut_box = cut_from_corners(box(Vec3(1, 2, 3)));
  const TriangleSoup tetrahedron = tetrahedron_soup(1);
  for (const Cut& cut :
       {Cut{"tetrahedron, each triangle split into four", split_at_middles(tetrahedron), 4, 6, 4},
        Cut{"box, each triangle split into four", split_at_middles(cut_box), 8, 12, 6}}) {
    require_solid_again(story, cut);
  }
  require_corners_of_a_flat_pyramid(story);
}

GRADED_TEST(Lab2, ChainsGoWithTheirInnerVertices, 4, "L2.8") {
  require_linked_merge();
  Story story("A flat face becomes one polygon, however it was cut into triangles");
  story
      .likely(
          "two faces that share a chain of edges lose all of it, and its inner vertices; an edge "
          "taken alone leaves vertices of degree one or two")
      .likely("where a union has a reflex vertex, the faces behind it join the union");
  const TriangleSoup cut_box = cut_from_corners(box(Vec3(1, 2, 3)));
  const Solid tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  // The point around which the top is cut is 2 µm beside one of its edges.
  TriangleSoup with_sliver = cut_from_centres(box(Vec3::Ones()));
  with_sliver.vertices[9] = Vec3(0, Real(1 - 2e-6), 1);
  for (const Cut& cut :
       {Cut{"tetrahedron, triangles cut around their centres", cut_from_centres(tetrahedron), 4, 6,
            4},
        Cut{"box, faces cut around their centres", cut_from_centres(box(Vec3::Ones())), 8, 12, 6},
        Cut{"dodecahedron, pentagons cut from a corner", cut_from_corners(dodecahedron()), 20, 30,
            12},
        Cut{"dodecahedron, pentagons cut around their centres", cut_from_centres(dodecahedron()),
            20, 30, 12},
        Cut{"box, its top cut around a point just beside an edge", with_sliver, 8, 12, 6},
        Cut{"box, each triangle split into sixteen", split_at_middles(split_at_middles(cut_box)), 8,
            12, 6}}) {
    require_solid_again(story, cut);
  }
}

}  // namespace
}  // namespace cs550::test
