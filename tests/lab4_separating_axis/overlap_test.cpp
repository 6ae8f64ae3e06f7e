// L4.5: the overlap test.
#include <cs550/graded_test.hpp>

#include "helpers/fixtures.hpp"
#include "lab4_separating_axis/crossed_shapes.hpp"
#include "lab4_separating_axis/gjk.hpp"

namespace cs550::test {
namespace {

Story with_overlap_causes(Story story) {
  return story.likely("bodies overlap if *no* axis separates: every kind of axis must be asked")
      .likely("touching counts: a separation of exactly 0 is no separation");
}

/// Whether the pair is so close to touching that rounding may decide. GJK has a tolerance of its
/// own.
bool nearly_touching(const ExactBody& a, const ExactBody& b) {
  return std::abs(best_separations(a, b).largest()) < 1e-4 * std::max(a.size, b.size);
}

GRADED_TEST(Lab4, OverlapAgreesWithGjk, 3, "L4.5", Long) {
  Random random(48);
  Story story =
      with_overlap_causes(Story("The bodies overlap if and only if GJK, in libccd, says so"));
  story.seed(random.seed()).when("overlap(A, B)");
  constexpr int pairs = 4096;
  int overlapping = 0;
  const std::vector<ShapePtr> shapes = small_shapes();
  for (int i = 0; i < pairs; ++i) {
    const TestPair pair = random_pair(random, shapes);
    const ExactBody a = pair.exact_a();
    const ExactBody b = pair.exact_b();
    const bool expected = gjk_overlap(a, b);
    const bool got = overlap(pair.a, pair.b);
    if (got != expected && nearly_touching(a, b)) continue;
    Story here = about(story, pair);
    here.given("pair number", i);
    require(here.expect_equal("they overlap", got, expected));
    if (got) ++overlapping;
  }
  story.expect_at_least("pairs that overlap", overlapping, 0.25 * pairs);
  story.expect_at_least("pairs that do not", pairs - overlapping, 0.25 * pairs);
}

GRADED_TEST(Lab4, CubesThatTouchOverlap, 1, "L4.5") {
  Story story = with_overlap_causes(Story("Cubes overlap up to the moment when they just touch"));
  const ShapePtr cube = fixture_shape("cube");
  const struct {
    Vec3 position;
    bool overlaps;
  } cases[] = {
      {{0, 0, 0}, true},           {{Real(0.5), Real(0.5), Real(0.5)}, true},
      {{1, 0, 0}, true},           {{1, 1, 1}, true},
      {{Real(1.01), 0, 0}, false}, {{0, 0, Real(-1.01)}, false},
      {{0, -3, 0}, false},
  };
  for (const auto& expected : cases) {
    const PosedShape a{cube.get(), {Vec3::Zero(), Quat::Identity()}};
    const PosedShape b{cube.get(), {expected.position, Quat::Identity()}};
    Story here = story;
    here.given("two cubes of 1 m, B at " + Story::show(expected.position, "m"));
    require(here.expect_equal("they overlap", overlap(a, b), expected.overlaps));
  }
  const CrossedPair crossed = barely_apart();
  Story apart = about(story, crossed.pair);
  apart.likely("any positive separation is enough, whatever ties with it");
  apart.expect_equal("they overlap", overlap(crossed.pair.a, crossed.pair.b), false);
}

}  // namespace
}  // namespace cs550::test
