// The same properties with other shapes, seeds and sizes.
#include <cs550/graded_test.hpp>

#include "helpers/fixtures.hpp"
#include "lab4_separating_axis/crossed_shapes.hpp"
#include "lab4_separating_axis/gjk.hpp"

namespace cs550::test {
namespace {

Story with_pair_causes(Story story) {
  return story.likely("the largest of all separations, faces of A, faces of B and edges")
      .likely("indices of more than 127 elements do not fit in 8 bits")
      .likely("tolerances are relative to the sizes of the bodies");
}

GRADED_TEST(Lab4, FlatThinAndRoundBodies, 3, "L4.4") {
  Random random(941);
  Story story =
      with_pair_causes(Story("Needles, slabs and slivers have a best axis like any other"));
  story.seed(random.seed()).when("find_separating_axis() without a hint");
  std::vector<ShapePtr> shapes;
  for (const char* name : {"needle", "slab", "sliver", "dodecahedron", "prism32", "hull32"}) {
    shapes.push_back(fixture_shape(name));
  }
  for (int i = 0; i < 40; ++i) {
    const TestPair pair = random_pair(random, shapes);
    const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, {}, HUGE_VALF);
    Story here = story;
    here.given("pair number", i);
    require_best_axis(here, pair, answer, HUGE_VALF, 2 * rounding);
  }
}

GRADED_TEST(Lab4, HullsOfManyVertices, 3, "L4.4") {
  Random random(942);
  Story story = with_pair_causes(Story("A hull of 256 vertices has a best axis like any other"));
  story.seed(random.seed()).when("find_separating_axis() against a cube, a tetrahedron, a prism");
  const std::vector<ShapePtr> shapes{fixture_shape("cube"), fixture_shape("regular_tetrahedron"),
                                     fixture_shape("prism6")};
  const ShapePtr hull = fixture_shape("hull256");
  for (int i = 0; i < 6; ++i) {
    TestPair pair = random_pair(random, shapes);
    (i % 2 == 0 ? pair.a : pair.b).shape = hull.get();
    const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, {}, HUGE_VALF);
    require_best_axis(story, pair, answer, HUGE_VALF, rounding);
  }
}

GRADED_TEST(Lab4, CrossedAtManyAngles, 3, "L4.3") {
  Story story =
      with_pair_causes(Story("Edges that cross at any angle separate along the vertical"));
  for (const Real size : {Real(2e-3), Real(0.012), Real(300)}) {
    for (const CrossedShape& shape : crossed_shapes()) {
      for (const Real degrees : {Real(8), Real(31), Real(77), Real(140)}) {
        const Real share = Real(0.02);
        const CrossedPair crossed = cross(shape, size, share, degrees * pi / 180);
        const EdgeQuery answer = query_edge_directions(crossed.pair.a, crossed.pair.b);
        Story here = about(story, crossed.pair);
        here.given("size", size, "m").given("angle between the edges", degrees, "degrees");
        require(here.expect("some arcs cross", static_cast<bool>(answer)));
        // At a small angle rounding tilts the axis: by 1e-7 / sin 8°.
        require(here.expect_near("separation", answer.separation, crossed.separation,
                                 2 * rounding * double{size}, "m"));
      }
    }
  }
}

GRADED_TEST(Lab4, OverlapOfSmallBodiesFarAway, 3, "L4.5") {
  Random random(943);
  Story story =
      with_pair_causes(Story("Bodies of 12 mm, 10 m away, overlap if and only if GJK says so"));
  story.seed(random.seed()).when("overlap(A, B)");
  const std::vector<ShapePtr> shapes = small_shapes(Real(0.012));
  int overlapping = 0;
  constexpr int pairs = 400;
  for (int i = 0; i < pairs; ++i) {
    const TestPair pair = random_pair(random, shapes, 10 * random.unit_vector());
    const ExactBody a = pair.exact_a();
    const ExactBody b = pair.exact_b();
    const bool expected = gjk_overlap(a, b);
    const bool got = overlap(pair.a, pair.b);
    // Coordinates of 10 m are rounded to 1e-6 m, 1e-4 of the size. Several roundings are allowed.
    const double band = 5e-4 * std::max(a.size, b.size);
    if (got != expected && std::abs(best_separations(a, b).largest()) < band) continue;
    Story here = about(story, pair);
    require(here.expect_equal("they overlap", got, expected));
    if (got) ++overlapping;
  }
  story.expect_at_least("pairs that overlap", overlapping, 0.25 * pairs);
  story.expect_at_least("pairs that do not", pairs - overlapping, 0.25 * pairs);
}

}  // namespace
}  // namespace cs550::test
