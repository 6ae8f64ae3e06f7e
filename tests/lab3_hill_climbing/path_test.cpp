// L3.2: the path of a climb, and its cost.
#include <cs550/graded_test.hpp>

#include <set>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

bool contains(const std::vector<Index>& list, Index item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// Checks one step of a path: it leads to a neighbour, the best one within the resolution of float.
void require_steepest_step(Story here, const HalfEdgeMesh& mesh, const Vec3& direction, Index from,
                           Index to) {
  here.given("on the path: from vertex " + std::to_string(from) + " to " + std::to_string(to));
  const std::vector<Index> choices = neighbours(mesh, from);
  require(here.expect("the step goes to a neighbour", contains(choices, to),
                      "vertex " + std::to_string(to), "one of " + Story::show(choices)));
  // In float, like the climb itself, so that the comparison is strict.
  require(here.expect("the step goes strictly up",
                      mesh.vertex(to).dot(direction) > mesh.vertex(from).dot(direction),
                      Story::show(height(mesh.vertex(to), direction), "m"),
                      "more than " + Story::show(height(mesh.vertex(from), direction), "m")));
  double best = -HUGE_VAL;
  for (const Index v : choices) best = std::max(best, height(mesh.vertex(v), direction));
  require(here.expect_near("height of the step", height(mesh.vertex(to), direction), best,
                           height_tolerance(mesh, direction), "m"));
}

GRADED_TEST(Lab3, PathGoesUpFromNeighbourToNeighbour, 5, "L3.2") {
  Random random(33);
  Story story("The path leads from the start to the answer, each step to the best neighbour");
  story.seed(random.seed()).when("hill_climb() with a path");
  story.likely("the path begins with the start, and has nothing in it from before")
      .likely("a vertex joins the path when you step onto it, not when you look at it")
      .likely("look at all neighbours before you step: the first better one need not be the best");
  std::size_t steps = 0;
  for (const std::string& name : convex_meshes()) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    for (int i = 0; i < 20; ++i) {
      const Vec3 direction = random.unit_vector();
      const Index start = random.integer(0, mesh.vertex_count() - 1);
      Story here = story;
      here.given("mesh " + name).given("direction", direction).given("start", start);
      std::vector<Index> path{17, 4, 2020};
      const Support answer = hill_climb(mesh, direction, start, &path);
      here.picture([&] { return walk_picture(mesh, direction, path); });
      require(here.expect("the path is not empty", !path.empty()));
      require(here.expect_equal("first vertex of the path", path.front(), start));
      require(here.expect_equal("last vertex of the path", path.back(), answer.vertex));
      for (std::size_t step = 1; step < path.size(); ++step) {
        require_steepest_step(here, mesh, direction, path[step - 1], path[step]);
      }
      steps += path.size() - 1;
    }
  }
  story.expect_at_least("steps on all paths together", static_cast<double>(steps), 300);
}

GRADED_TEST(Lab3, VisitsAreTheNeighboursOfThePath, 2, "L3.2") {
  Random random(34);
  Story story("Every vertex next to the path is measured, and no others");
  story.seed(random.seed()).when("hill_climb() with a path");
  story.likely("the start is the first visit")
      .likely("each neighbour counts, whether it is better or not");
  const HalfEdgeMesh& mesh = fixture_mesh("icosphere2");
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction = random.unit_vector();
    const Index start = random.integer(0, mesh.vertex_count() - 1);
    std::vector<Index> path;
    const Support answer = hill_climb(mesh, direction, start, &path);
    require(story.expect("the path is not empty", !path.empty()));
    std::set<Index> seen{start};
    std::size_t looks = 1;
    for (const Index v : path) {
      require(story.expect_index("vertex on the path", v, mesh.vertex_count()));
      for (const Index w : neighbours(mesh, v)) {
        seen.insert(w);
        ++looks;
      }
    }
    Story here = story;
    here.given("direction", direction)
        .given("start", start)
        .given("vertices on the path", path.size());
    here.picture([&] { return walk_picture(mesh, direction, path); });
    // A climb that remembers visited vertices needs fewer dot products.
    require(here.expect_at_least("visited", answer.visited, static_cast<double>(seen.size())));
    require(here.expect_at_most("visited", answer.visited, static_cast<double>(looks)));
  }
}

GRADED_TEST(Lab3, VisitsGrowLikeTheSquareRootOfTheVertices, 5, "L3.2") {
  Random random(35);
  Story story("Four times the vertices cost about twice the visits");
  story.seed(random.seed()).when("hill_climb() between random places of spheres");
  story.likely("a climb looks at the neighbours of where it stands and at nothing else")
      .likely("continue from the new vertex instead of beginning again");
  double mean_before = 0;
  for (const std::string name : {"icosphere1", "icosphere2", "icosphere3"}) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    const double root = std::sqrt(static_cast<double>(mesh.vertex_count()));
    double sum = 0;
    constexpr int climbs = 400;
    Story here = story;
    here.given("mesh " + name).given("vertices", mesh.vertex_count());
    for (int i = 0; i < climbs; ++i) {
      const Vec3 direction = random.unit_vector();
      const Support answer =
          hill_climb(mesh, direction, random.integer(0, mesh.vertex_count() - 1));
      require_highest(here, mesh, direction, answer.vertex);
      sum += answer.visited;
      // Half way round the sphere is about √n edges, with 6 neighbours at each stop, and a detour
      // of up to 2/√3 on a grid of triangles: 7·√n.
      require(here.expect_at_most("visits of one climb", answer.visited, 1 + 7 * (root + 1)));
    }
    const double mean = sum / climbs;
    // On average a quarter of the circumference: half as many.
    require(here.expect_at_most("mean number of visits", mean, 3.5 * (root + 1)));
    if (mean_before > 0) {
      require(here.expect_at_most("growth of the mean for 4 times the vertices", mean / mean_before,
                                  2.4));
    }
    mean_before = mean;
  }
}

}  // namespace
}  // namespace cs550::test
