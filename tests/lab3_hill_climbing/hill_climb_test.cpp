// L3.2: the end of a climb.
#include <cs550/graded_test.hpp>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab3, HillClimbMatchesBruteForceFromEveryStart, 6, "L3.2") {
  Random random(32);
  Story story("From every start the climb ends at a vertex as extreme as any");
  story.seed(random.seed()).when("hill_climb()");
  story.likely("compare dot(vertex, direction), not the distance from the origin")
      .likely("keep walking until no neighbour is better, not only one step")
      .likely("leave the loop when no neighbour is better: the climb ends there")
      .likely("the vertices around v: half-edges that leave v, each points to a neighbour");
  for (const std::string& name : convex_meshes()) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    for (const Vec3& direction : directions_for(mesh, random, 4)) {
      for (Index start = 0; start < mesh.vertex_count(); ++start) {
        Story here = story;
        here.given("mesh " + name).given("start", start);
        const Support answer = hill_climb(mesh, direction, start);
        require_highest(here, mesh, direction, answer.vertex);
      }
    }
  }
}

GRADED_TEST(Lab3, ClimbEndsOnAPlateau, 4, "L3.2") {
  Story story("Where many vertices are equally high the climb stops at the first that it meets");
  story.when("hill_climb() along a face normal");
  story.likely("step only to a strictly better neighbour: with >= it walks round the plateau")
      .likely("the neighbours of one vertex can be equal as well: take the first of them");
  for (const std::string name : {"cube", "triangulated_cube", "prism32"}) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    // The top, z = ½ m, is a plateau in all of these; the coordinates are exact.
    for (Index start = 0; start < mesh.vertex_count(); ++start) {
      Story here = story;
      here.given("mesh " + name).given("start", start).given("direction +z");
      std::vector<Index> path;
      const Support answer = hill_climb(mesh, Vec3::UnitZ(), start, &path);
      require_highest(here, mesh, Vec3::UnitZ(), answer.vertex);
      here.picture([&] { return walk_picture(mesh, Vec3::UnitZ(), path); });
      const bool starts_on_top = mesh.vertex(start).z() > 0;
      if (starts_on_top) require(here.expect_equal("the climb stays at", answer.vertex, start));
      require(here.expect_at_most("vertices on the path", static_cast<double>(path.size()), 2));
    }
  }
}

GRADED_TEST(Lab3, ClimbStopsAtALocalMaximum, 4, "L3.2") {
  Story story(
      "A climb sees only its neighbours: on a mesh that is not convex it stops at a top "
      "that need not be the highest");
  story.given("mesh twin_peaks: vertex 6 at 1 m and vertex 7 at 2 m, a lower ridge between them");
  story.given("direction +z");
  story.likely("look at neighbours only: a search over all vertices is no climb")
      .likely("begin at the start that was asked for");
  const HalfEdgeMesh& mesh = fixture_mesh("twin_peaks");
  const struct {
    Index start;
    Index top;
  } climbs[] = {{6, 6}, {7, 7}, {5, 6}, {3, 7}};
  for (const auto& climb : climbs) {
    Story here = story;
    here.given("start", climb.start);
    const Support answer = hill_climb(mesh, Vec3::UnitZ(), climb.start);
    require(here.expect_equal("the climb ends at vertex", answer.vertex, climb.top));
  }
}

}  // namespace
}  // namespace cs550::test
