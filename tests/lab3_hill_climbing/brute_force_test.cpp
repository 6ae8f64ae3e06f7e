// L3.1: brute force over all vertices.
#include <cs550/graded_test.hpp>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

Story with_scan_causes(Story story) {
  return story.likely("compare dot(vertex, direction), not the distance from the origin")
      .likely("begin with the first vertex: a best value of 0 hides vertices behind the origin")
      .likely("the loop must reach the last vertex");
}

GRADED_TEST(Lab3, BruteForceFindsTheMostExtremeVertex, 4, "L3.1") {
  Random random(31);
  Story story = with_scan_causes(Story("No vertex is farther along the direction than the answer"));
  story.seed(random.seed()).when("support_brute_force()");
  for (const std::string& name : convex_meshes()) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    Story here = story;
    here.given("mesh " + name);
    for (const Vec3& direction : directions_for(mesh, random, 8)) {
      const Support answer = support_brute_force(mesh.vertices, direction);
      require_highest(here, mesh, direction, answer.vertex);
      require(here.expect_equal("vertices visited", answer.visited, mesh.vertex_count()));
    }
  }
}

GRADED_TEST(Lab3, FarthestVertexNeedNotBeTheMostExtreme, 2, "L3.1") {
  Story story = with_scan_causes(Story("A vertex far to the side does not count as far along"));
  const std::vector<Vec3> vertices{{10, 0, 0}, {0, 10, 0}, {1, 1, 2}, {0, 0, -20}};
  story.given("vertices (10,0,0), (0,10,0), (1,1,2), (0,0,-20)").given("direction +z");
  const Support answer = support_brute_force(vertices, Vec3::UnitZ());
  story.expect_equal("most extreme vertex", answer.vertex, Index{2});
}

GRADED_TEST(Lab3, VerticesBehindTheOriginHaveAnExtremeToo, 2, "L3.1") {
  Story story =
      with_scan_causes(Story("The largest of negative numbers is an answer like any other"));
  const std::vector<Vec3> vertices{{0, 0, -7}, {1, 0, -5}, {0, 1, -3}, {1, 1, -4}};
  story.given("vertices with z = -7, -5, -3, -4").given("direction +z");
  const Support answer = support_brute_force(vertices, Vec3::UnitZ());
  story.expect_equal("most extreme vertex", answer.vertex, Index{2});
  story.expect_equal("vertices visited", answer.visited, 4);
}

GRADED_TEST(Lab3, FirstOfEqualVerticesWins, 2, "L3.1") {
  Story story("Among equal vertices the first one wins, whatever the length of the direction");
  story.likely("only a strictly better vertex takes over: > and not >=");
  const std::vector<Vec3> vertices{{0, 0, 1}, {5, 0, 2}, {0, 5, 2}, {-5, 0, 2}, {0, 0, -2}};
  story.given("vertices 1, 2 and 3 with z = 2, the others lower");
  for (const Real length : {Real(1), Real(1e-3), Real(1e3)}) {
    Story here = story;
    here.given("direction +z, length " + Story::show(length));
    const Support answer = support_brute_force(vertices, length * Vec3::UnitZ());
    require(here.expect_equal("most extreme vertex", answer.vertex, Index{1}));
  }
}

}  // namespace
}  // namespace cs550::test
