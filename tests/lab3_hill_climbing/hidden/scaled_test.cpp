// The same properties for bodies of 1 mm to 1 km, other directions and other hulls.
#include <cs550/graded_test.hpp>

#include "lab3_hill_climbing/climbing.hpp"

namespace cs550::test {
namespace {

constexpr Real sizes[] = {Real(1e-3), Real(1e-1), Real(1e1), Real(1e3)};

GRADED_TEST(Lab3, BruteForceAtAnySize, 2, "L3.1") {
  Random random(931);
  Story story("No vertex is farther along the direction than the answer, 1 mm or 1 km");
  story.seed(random.seed()).when("support_brute_force() of a cloud away from the origin");
  story.likely("begin with the first vertex, not with a best value of 0")
      .likely("no threshold belongs in the comparison");
  for (const Real size : sizes) {
    HalfEdgeMesh mesh = scaled(fixture_mesh("hull64"), size);
    const Vec3 shift = 3 * size * random.unit_vector();
    for (Vec3& vertex : mesh.vertices) vertex += shift;
    Story here = story;
    here.given("size", size, "m");
    for (int i = 0; i < 50; ++i) {
      const Vec3 direction = random.real(Real(0.01), 100) * random.unit_vector();
      const Support answer = support_brute_force(mesh.vertices, direction);
      require_highest(here, mesh, direction, answer.vertex);
      require(here.expect_equal("vertices visited", answer.visited, mesh.vertex_count()));
    }
  }
}

GRADED_TEST(Lab3, HillClimbAtAnySize, 4, "L3.2") {
  Random random(932);
  Story story("From every start the climb ends at a vertex as extreme as any, 1 mm or 1 km");
  story.seed(random.seed()).when("hill_climb()");
  story.likely("no threshold belongs in the comparison: strictly better is better")
      .likely("the direction may have any length");
  for (const std::string name : {"corner_tetrahedron", "hull16", "bunny_hull", "teapot_hull"}) {
    for (const Real size : sizes) {
      const HalfEdgeMesh mesh = scaled(fixture_mesh(name), size);
      Story here = story;
      here.given("mesh " + name).given("size", size, "m");
      for (int i = 0; i < 30; ++i) {
        const Vec3 direction = random.real(Real(0.01), 100) * random.unit_vector();
        const Index start = random.integer(0, mesh.vertex_count() - 1);
        require_highest(here, mesh, direction, hill_climb(mesh, direction, start).vertex);
      }
    }
  }
}

GRADED_TEST(Lab3, ClimbFromTheAnswerStays, 3, "L3.2") {
  Random random(933);
  Story story("Begun at the answer, a climb looks at its neighbours and stays");
  story.seed(random.seed()).when("hill_climb() twice, the second time from the first answer");
  story.likely("use the start that is given").likely("a path that is given anew begins anew");
  for (const std::string name : {"cube", "dodecahedron", "hull256"}) {
    const HalfEdgeMesh& mesh = fixture_mesh(name);
    std::vector<Index> path;
    for (int i = 0; i < 50; ++i) {
      const Vec3 direction = random.unit_vector();
      const Index top = hill_climb(mesh, direction, 0, &path).vertex;
      Story here = story;
      here.given("mesh " + name).given("direction", direction);
      require_highest(here, mesh, direction, top);
      const Support again = hill_climb(mesh, direction, top, &path);
      require(here.expect_equal("second answer", again.vertex, top));
      require(here.expect_equal("vertices on the second path", path.size(), std::size_t{1}));
      const double degree = static_cast<double>(neighbours(mesh, top).size());
      require(here.expect_near("visits of the second climb", again.visited, 1 + degree, 0));
    }
  }
}

GRADED_TEST(Lab3, SupportOfSmallAndLargeBodies, 3, "L3.3") {
  Random random(934);
  Story story("The most extreme point of a turned and moved body, 1 mm or 1 km");
  story.seed(random.seed()).when("support()");
  story.likely("d_local = Rᵀ·d, with no translation").likely("the point is R·v + x");
  for (const Real size : sizes) {
    ConvexShape shape;
    shape.mesh = scaled(fixture_mesh("hull16"), size);
    for (int i = 0; i < 50; ++i) {
      const Vec3 place = 100 * size * random.unit_vector();
      const PosedShape body{&shape, {place, random.orientation()}};
      const Vec3 direction = random.unit_vector();
      Story here = story;
      here.given("size", size, "m").given("position", place, "m").given("direction", direction);
      const SupportPoint answer = support(body, direction, random.integer(0, 15));
      require(here.expect_index("vertex of the answer", answer.vertex, shape.mesh.vertex_count()));
      double greatest = -HUGE_VAL;
      for (Index v = 0; v < shape.mesh.vertex_count(); ++v) {
        greatest = std::max(greatest, height(body.vertex(v), direction));
      }
      // Rounding at 100 sizes from the origin.
      const double tolerance = 4e-5 * double{size};
      require(here.expect_near("height of the point", height(answer.point, direction), greatest,
                               tolerance, "m"));
      require(here.expect_near("the point in the world", answer.point, body.vertex(answer.vertex),
                               tolerance, "m"));
    }
  }
}

}  // namespace
}  // namespace cs550::test
