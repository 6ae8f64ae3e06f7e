// L4.4: the preference among features of equal separation, and its limits.
#include <cs550/graded_test.hpp>

#include "helpers/fixtures.hpp"
#include "lab4_separating_axis/axis_oracle.hpp"
#include "lab4_separating_axis/crossed_shapes.hpp"

namespace cs550::test {
namespace {

/// Two cubes at crossed edges that overlap so deeply that a face of each and the edges have the
/// same separation: z − √2 = −½ − ½√2 times the size.
constexpr Real tie_height = Real(0.20710678);
constexpr double tie_separation = -1.2071068;

CrossedPair deep_cubes(Real size) {
  CrossedPair crossed = cross(crossed_shapes()[0], size, 0);
  crossed.pair.b.pose.position = Vec3(0, 0, tie_height * size);
  return crossed;
}

/// The answer of the last step if that kind had won, or none if no edges are given.
SeparatingAxis hint_of_kind(AxisFeature kind, const TestPair& pair) {
  SeparatingAxis hint;
  hint.face_a = query_face_directions(pair.a, pair.b);
  hint.face_b = query_face_directions(pair.b, pair.a);
  hint.edges = query_edge_directions(pair.a, pair.b);
  const bool exists = kind != AxisFeature::Edges || hint.edges;
  hint.feature = exists ? kind : AxisFeature::None;
  return hint;
}

std::string name_of(AxisFeature feature) {
  const char* names[] = {"None", "FaceA", "FaceB", "Edges"};
  return names[static_cast<int>(feature)];
}

/// No arcs of aligned cubes cross. A face of each ties, and an edge query of separation 0 would beat both.
void require_faces_without_edges(Story story) {
  const ShapePtr cube = fixture_shape("cube");
  const TestPair pair{{cube.get(), {Vec3::Zero(), Quat::Identity()}},
                      {cube.get(), {Vec3(0, 0, Real(0.9)), Quat::Identity()}},
                      "two aligned cubes of 1 m, B 0.9 m above A: no arcs cross"};
  story.likely("an empty edge query has no separation: it is no candidate, though its 0 is larger");
  story.likely("an empty edge query is no candidate, also if the hint names edges");
  for (const AxisFeature kind :
       {AxisFeature::None, AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
    Story here = about(story, pair);
    here.given("hint", name_of(kind));
    SeparatingAxis hint = hint_of_kind(kind, pair);
    hint.feature = kind;
    hint.edges = {0, 0, Vec3::UnitZ(), 0};  // of earlier poses, at which their arcs crossed
    const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, hint, HUGE_VALF);
    const AxisFeature expected =
        kind == AxisFeature::FaceB ? AxisFeature::FaceB : AxisFeature::FaceA;
    require(here.expect_equal("feature", name_of(answer.feature), name_of(expected)));
    require(here.expect_near("separation", answer.separation, -0.1, 1e-6, "m"));
    require(here.expect_near("axis", answer.axis, Vec3::UnitZ(), 1e-6));
  }
}

/// B's face ties with A's face and with the edges, which do not tie: they are better by 1.5 tolerances.
void require_no_chain_of_ties(Story story, Real size) {
  CrossedPair crossed = deep_cubes(size);
  TestPair& pair = crossed.pair;
  // The slopes of the separations: A's face gains z/√2, B's face (x + z)/√2 and the edges z.
  const Real tie = tie_tolerance * pair.smaller_radius();
  const Real root = std::sqrt(Real(2));
  pair.b.pose.position.x() = Real(0.75) * root * tie;
  pair.b.pose.position.z() += Real(1.5) * root / (root - 1) * tie;
  story.given("two crossed cubes of side " + Story::show(size, "m"))
      .given("B's face is better than A's by 0.75 of the tolerance of a tie, the edges by 1.5");
  for (const AxisFeature kind :
       {AxisFeature::None, AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
    const SeparatingAxis answer =
        find_separating_axis(pair.a, pair.b, hint_of_kind(kind, pair), HUGE_VALF);
    const AxisFeature expected =
        kind == AxisFeature::Edges ? AxisFeature::Edges : AxisFeature::FaceB;
    Story here = about(story, pair);
    here.given("hint", name_of(kind));
    require(here.expect_equal("feature", name_of(answer.feature), name_of(expected)));
  }
}

GRADED_TEST(Lab4, TiesKeepTheKindOfTheHint, 3, "L4.4") {
  Story story("On a tie last step's kind of feature stays; without one A's face comes first");
  const Story without_edges = story;
  story.likely("a tie is a difference below tie_tolerance times the smaller radius: relative")
      .likely("compare every kind with the largest separation, not each with the one before");
  const Story of_other_poses = story;
  story.given("two crossed cubes, so deep that a face of A, a face of B and the edges tie");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    const CrossedPair crossed = deep_cubes(size);
    const TestPair& pair = crossed.pair;
    for (const AxisFeature kind :
         {AxisFeature::None, AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
      const SeparatingAxis hint = hint_of_kind(kind, pair);
      const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, hint, 0);
      const AxisFeature expected = kind == AxisFeature::None ? AxisFeature::FaceA : kind;
      Story here = about(story, pair);
      here.given("size", size, "m").given("hint", name_of(kind));
      require(here.expect_near("separation", answer.separation, tie_separation * double{size},
                               2e-4 * double{size}, "m"));
      require(here.expect_equal("feature", name_of(answer.feature), name_of(expected)));
    }
    require_no_chain_of_ties(of_other_poses, size);
  }
  require_faces_without_edges(without_edges);
}

/// A cube of 1 m rests on one of 100 m, a little turned: its face is worse by more than a tie of the smaller body,
/// and by less than one of the larger.
void require_ties_of_the_smaller_body(Story story) {
  const ShapePtr large = scaled_shape("cube", 100);
  const ShapePtr small = fixture_shape("cube");
  const TestPair pair{{large.get(), {Vec3::Zero(), Quat::Identity()}},
                      {small.get(), {Vec3(0, 0, Real(50.4)), rotation_exp(Vec3(0, Real(1e-5), 0))}},
                      "a cube of 1 m, turned by 1e-5 rad, 0.1 m deep in one of 100 m"};
  story.likely("of two bodies the smaller radius gives the tolerance");
  const auto require_kind = [&](const TestPair& bodies, AxisFeature hint, AxisFeature expected) {
    Story here = about(story, bodies);
    here.given("hint", name_of(hint));
    const SeparatingAxis answer =
        find_separating_axis(bodies.a, bodies.b, hint_of_kind(hint, bodies), HUGE_VALF);
    require(here.expect_equal("feature", name_of(answer.feature), name_of(expected)));
  };
  require_kind(pair, AxisFeature::FaceB, AxisFeature::FaceA);
  require_kind(pair.swapped(), AxisFeature::FaceA, AxisFeature::FaceB);
}

/// The kind that exceeds the two others by 1 % of the smaller radius, or None.
AxisFeature clearly_best(const TestPair& pair) {
  const BestSeparations best = best_separations(pair.exact_a(), pair.exact_b());
  const double clear = 0.01 * double{pair.smaller_radius()};
  if (best.face_a > std::max(best.face_b, best.edges) + clear) return AxisFeature::FaceA;
  if (best.face_b > std::max(best.face_a, best.edges) + clear) return AxisFeature::FaceB;
  if (best.edges > best.faces() + clear) return AxisFeature::Edges;
  return AxisFeature::None;
}

GRADED_TEST(Lab4, AHintDoesNotWinAgainstABetterAxis, 2, "L4.4") {
  Random random(49);
  Story story("However deep the bodies are, the largest separation wins unless it is a tie");
  const Story of_other_pairs = story;
  story.seed(random.seed()).given("pairs whose best axis is better by 1 % of the smaller radius");
  story.likely("separations are negative here: a tolerance as a factor turns the wrong way")
      .likely("the tolerance is a share of the radius, not of the depth, and not in metres");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    const std::vector<ShapePtr> shapes = small_shapes(size);
    int seen[4] = {0, 0, 0, 0};
    for (int i = 0; i < 150; ++i) {
      const Vec3 place = size * random.point_in_box({3, 3, 3});
      TestPair pair = random_pair(random, shapes, place);
      pair.approach(Real(0.5));  // deep
      const AxisFeature best = clearly_best(pair);
      if (best == AxisFeature::None) continue;
      ++seen[static_cast<int>(best)];
      for (const AxisFeature kind :
           {AxisFeature::None, AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
        const SeparatingAxis hint = hint_of_kind(kind, pair);
        const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, hint, HUGE_VALF);
        Story here = about(story, pair);
        here.given("size", size, "m").given("hint", name_of(kind));
        require(here.expect_equal("feature", name_of(answer.feature), name_of(best)));
      }
    }
    for (int kind = 1; kind < 4; ++kind) {
      // 26 ± 5 over all seeds: the bound holds for every salt of a course.
      story.expect_at_least("pairs in which each kind is the best", seen[kind], 5);
    }
  }
  require_ties_of_the_smaller_body(of_other_pairs);
}

}  // namespace
}  // namespace cs550::test
