// L2.8 and L2.9 again: finely triangulated boxes at every scale, and hulls of scanned meshes.
#include <cs550/graded_test.hpp>

#include "cs550/mesh_io.hpp"
#include "lab2_half_edge_mesh/mesh_checks.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab2, FinelyCutBodiesMergeAtEveryScale, 2, "L2.8") {
  require_linked_merge();
  Random random(271);
  Story story(
      "A box cut into hundreds of triangles is a box again, at every scale and in every pose");
  story.seed(random.seed())
      .likely("a chain of shared edges goes as a whole; a straight vertex with two edges goes too");
  const TriangleSoup bodies[] = {
      split_at_middles(cut_from_centres(box(Vec3(1, 1, 3)))),
      split_at_middles(split_at_middles(cut_from_corners(box(Vec3(3, 1, 2)))))};
  for (const TriangleSoup& body : bodies) {
    for (const Real scale : {Real(1e-3), Real(0.05), Real(1), Real(40), Real(1e3)}) {
      const TriangleSoup soup =
          placed(body, scale, random.orientation(), 2 * scale * random.unit_vector());
      Story here = story;
      here.given("triangles", soup.triangles.size()).given("scale", scale);
      const HalfEdgeMesh built = require_mesh(shuffled(soup, random), here);
      const HalfEdgeMesh mesh = merge_coplanar_faces(built);
      require(expect_counts(here, mesh, 8, 12, 6));
      require(expect_valid(here, mesh));
    }
  }
}

GRADED_TEST(Lab2, HullsOfScannedMeshesStaySound, 2, "L2.9") {
  require_linked_merge();
  Story story(
      "The merged hull of a scanned mesh is closed, convex, and has the volume of the hull");
  story.likely("noise makes thin triangles: a merged plane must not tip out of them")
      .likely("a merge that leaves a face with two corners must not happen");
  for (const char* name : {"bunny", "teapot"}) {
    const SoupResult scan = load_obj(std::string(CS550_ASSETS "/meshes/") + name + ".obj");
    const SoupResult hull = convex_hull(scan.soup.vertices);
    for (const Real tolerance : {coplanar_tolerance, Real(1e-4), Real(1e-3)}) {
      Story here = story;
      here.given(std::string("hull of the ") + name).given("tolerance", tolerance);
      const HalfEdgeMesh built = require_mesh(hull.soup, here);
      const HalfEdgeMesh mesh = merge_coplanar_faces(built, tolerance);
      require(expect_valid(here, mesh, 5 * tolerance + Real(1e-4)));
      // Faces move by at most the slack, over an area of about six times size².
      here.expect_near("volume, over that of the hull", volume(mesh) / volume(built), 1,
                       20 * double(tolerance));
      here.expect_at_most("faces", mesh.face_count(), built.face_count() - 1);
    }
  }
}

}  // namespace
}  // namespace cs550::test
