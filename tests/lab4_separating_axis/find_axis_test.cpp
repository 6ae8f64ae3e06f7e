// L4.4: the best axis of all.
#include <cs550/graded_test.hpp>

#include "helpers/fixtures.hpp"
#include "lab4_separating_axis/axis_oracle.hpp"
#include "lab4_separating_axis/crossed_shapes.hpp"

namespace cs550::test {
namespace {

Story with_axis_causes(Story story) {
  return story.likely("the answer is the *largest* separation of faces of A, faces of B and edges")
      .likely("ask the edges also if a face separates: they may separate by more")
      .likely("the axis points from A to B: a face of B gives its negated normal")
      .likely("axis and separation belong to the feature that is named");
}

/// The number of pairs of each kind in a test. A bound is meaningful only if all kinds occur.
struct Census {
  int separated = 0;
  int within_margin = 0;
  int penetrating = 0;
  int edges_win = 0;
  int edges_win_apart = 0;

  void count(const SeparatingAxis& answer, Real margin) {
    if (answer.separation > margin) {
      ++separated;
      return;
    }
    ++(answer.separation > 0 ? within_margin : penetrating);
    if (answer.feature != AxisFeature::Edges) return;
    ++edges_win;
    if (answer.separation > 0) ++edges_win_apart;
  }
  void expect_variety(Story& story, int pairs) const {
    story.expect_at_least("pairs separated by more than the margin", separated, 0.125 * pairs);
    story.expect_at_least("pairs apart by less than the margin", within_margin, 0.05 * pairs);
    story.expect_at_least("pairs that penetrate", penetrating, 0.25 * pairs);
    story.expect_at_least("pairs where edges are best", edges_win, 0.1 * pairs);
    story.expect_at_least("pairs apart where edges are best", edges_win_apart, 0.01 * pairs);
  }
};

GRADED_TEST(Lab4, AxisMatchesBruteForce, 5, "L4.4", Long) {
  Random random(45);
  Story story =
      with_axis_causes(Story("No face normal and no cross product of edges separates more"));
  story.seed(random.seed()).when("find_separating_axis() without a hint");
  constexpr int pairs = 4096;
  Census census;
  const std::vector<ShapePtr> shapes = small_shapes();
  for (int i = 0; i < pairs; ++i) {
    const TestPair pair = random_pair(random, shapes);
    const Real margin = Real(0.1) * pair.smaller_radius();
    const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, {}, margin);
    Story here = story;
    here.given("pair number", i).given("margin", margin, "m");
    require_best_axis(here, pair, answer, margin, rounding);
    census.count(answer, margin);
  }
  census.expect_variety(story, pairs);
}

GRADED_TEST(Lab4, AxisAtAnySizeAndFarFromTheOrigin, 2, "L4.4") {
  Random random(46);
  Story story =
      with_axis_causes(Story("Neither the unit of length nor the place changes the axis"));
  story.seed(random.seed()).when("find_separating_axis() without a hint");
  story.likely("tolerances are relative: sines, and shares of the smaller radius");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    const std::vector<ShapePtr> shapes = small_shapes(size);
    for (const Real distance : {Real(0), Real(1000) * size}) {
      for (int i = 0; i < 40; ++i) {
        const TestPair pair = random_pair(random, shapes, distance * random.unit_vector());
        const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, {}, HUGE_VALF);
        Story here = story;
        here.given("size", size, "m").given("distance from the origin", distance, "m");
        // Coordinates of 1000 sizes have errors of 6e-5 sizes: the world frame may be used.
        const double tolerance = distance > 0 ? 5e-4 : rounding;
        require_best_axis(here, pair, answer, HUGE_VALF, tolerance);
      }
    }
  }
}

/// Whether an answer for (B, A) has the feature of one for (A, B).
bool same_feature_swapped(const SeparatingAxis& one, const SeparatingAxis& other) {
  switch (one.feature) {
    case AxisFeature::FaceA:
      return other.feature == AxisFeature::FaceB && one.face_a.face == other.face_b.face;
    case AxisFeature::FaceB:
      return other.feature == AxisFeature::FaceA && one.face_b.face == other.face_a.face;
    case AxisFeature::Edges:
      return other.feature == AxisFeature::Edges && one.edges.edge_a == other.edges.edge_b &&
             one.edges.edge_b == other.edges.edge_a;
    case AxisFeature::None:
      return false;
  }
  return false;
}

GRADED_TEST(Lab4, SwappedBodiesTurnTheAxisRound, 1, "L4.4") {
  Random random(47);
  Story story =
      with_axis_causes(Story("Swapping A and B keeps the separation and turns the axis round"));
  story.seed(random.seed()).when("find_separating_axis(A, B) and find_separating_axis(B, A)");
  const std::vector<ShapePtr> shapes = small_shapes();
  int turned = 0;
  for (int i = 0; i < 100; ++i) {
    const TestPair pair = random_pair(random, shapes);
    const SeparatingAxis one = find_separating_axis(pair.a, pair.b, {}, HUGE_VALF);
    const SeparatingAxis other = find_separating_axis(pair.b, pair.a, {}, HUGE_VALF);
    const double tie = double{tie_tolerance} * double{pair.smaller_radius()};
    const double tolerance = tie + rounding * double{pair.larger_radius()};
    Story here = about(story, pair);
    require(here.expect_near("separation after the swap", other.separation, one.separation,
                             tolerance, "m"));
    if (!same_feature_swapped(one, other)) continue;  // a tie
    ++turned;
    require(here.expect_near("axis after the swap", other.axis, -one.axis, 1e-5));
  }
  story.expect_at_least("pairs with the same feature before and after", turned, 80);
  for (const CrossedShape& shape : crossed_shapes()) {
    const CrossedPair crossed = cross(shape, 1, Real(0.05));
    const TestPair swapped = crossed.pair.swapped();
    const SeparatingAxis answer = find_separating_axis(swapped.a, swapped.b, {}, HUGE_VALF);
    Story here = about(story, swapped);
    require(here.expect_near("axis", answer.axis, -Vec3::UnitZ(), 1e-5));
  }
}

/// The half-edge, of even number, with the middle farthest along a direction of the world.
Index edge_towards(const PosedShape& body, const Vec3& direction) {
  const HalfEdgeMesh& mesh = body.mesh();
  const auto reach = [&](Index e) {
    const Vec3 doubled_middle = mesh.vertex(mesh.origin(e)) + mesh.vertex(mesh.edge(e).vertex);
    return body.pose.rotate(doubled_middle).dot(direction);
  };
  Index farthest = 0;
  for (Index e = 2; e < mesh.edge_count(); e += 2) {
    if (reach(e) > reach(farthest)) farthest = e;
  }
  return farthest;
}

/// Edges that still separate by more than the margin answer before any face is tested.
void require_hinted_edges_first(Story story) {
  constexpr Real margin = Real(0.01);
  const CrossedPair crossed = cross(crossed_shapes()[0], 1, Real(-0.05));
  const PosedShape& a = crossed.pair.a;
  const PosedShape& b = crossed.pair.b;
  SeparatingAxis hint;
  hint.feature = AxisFeature::Edges;
  hint.edges = {edge_towards(a, Vec3::UnitZ()), edge_towards(b, -Vec3::UnitZ()), Vec3::UnitZ(),
                margin};
  story = about(story, crossed.pair);
  story.given("hint: the edges that face each other").given("margin", margin, "m");
  const SeparatingAxis answer = find_separating_axis(a, b, hint, margin);
  require(
      story.expect("the answer has the feature of the hint", answer.feature == AxisFeature::Edges));
  require(story.expect("no face was tested: both face queries are empty",
                       !answer.face_a && !answer.face_b));
  require(story.expect_near("separation", answer.separation, crossed.separation, 1e-5, "m"));
  require(story.expect_near("axis", answer.axis, Vec3::UnitZ(), 1e-5));
}

/// A face of one body separates by more than the margin, no face of the other does, and arcs cross. So all three
/// queries would find something, but the search has to end before the last one.
void require_an_empty_query(Story story) {
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape turned{cube.get(),
                          {Vec3::Zero(), rotation_exp(Vec3(Real(0.2), Real(0.3), pi / 4))}};
  const PosedShape upright{cube.get(), {Vec3(2, 0, 0), Quat::Identity()}};
  story
      .given(
          "two cubes of 1 m: a face of the upright one separates by 0.67 m, no face of the turned "
          "one by 0.1 m")
      .given("margin 0.5 m");
  for (const TestPair& pair : {TestPair{turned, upright, "a turned cube and an upright one"},
                               TestPair{upright, turned, "an upright cube and a turned one"}}) {
    Story here = about(story, pair);
    const SeparatingAxis answer = find_separating_axis(pair.a, pair.b, {}, Real(0.5));
    require(here.expect("an axis beyond the margin", answer.separation > Real(0.5)));
    require(here.expect("at least one of the three queries is empty",
                        !(answer.face_a && answer.face_b && answer.edges)));
  }
}

/// An axis of edges beyond the margin is returned although a face that does not separate ties with it. Without
/// the margin either may win.
void require_edges_beyond_the_margin(Story story) {
  const CrossedPair crossed = barely_apart();
  story.likely("edges beyond the margin are the answer, whatever ties with them");
  for (const Real margin : {Real(0), HUGE_VALF}) {
    Story here = story;
    here.given("margin", margin, "m");
    const SeparatingAxis answer = find_separating_axis(crossed.pair.a, crossed.pair.b, {}, margin);
    require_best_axis(here, crossed.pair, answer, margin, rounding);
  }
}

GRADED_TEST(Lab4, TheMarginEndsTheSearch, 3, "L4.4") {
  Story story("A separation beyond the margin is an early out, the hint's own feature first");
  story.likely("evaluate the face or the edges of the hint at today's poses before all others")
      .likely("stop when separation > margin, not when it is > 0")
      .likely("a margin of HUGE_VALF never stops: then the largest separation is wanted")
      .likely("return as soon as a separation exceeds the margin: the queries after it stay empty");
  const Story of_other_pairs = story;
  story.given("two cubes of 1 m, B at (2, 3, 0) m: x separates by 1 m, y by 2 m");
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape a{cube.get(), {Vec3::Zero(), Quat::Identity()}};
  const PosedShape b{cube.get(), {Vec3(2, 3, 0), Quat::Identity()}};
  const TestPair pair{a, b, "two cubes"};
  const auto face_towards = [&](const Vec3& normal) {
    Index face = 0;
    while (cube->mesh.face(face).plane.normal.dot(normal) < Real(0.99)) ++face;
    return face;
  };

  SeparatingAxis hint_a;
  hint_a.feature = AxisFeature::FaceA;
  hint_a.face_a = {face_towards(Vec3::UnitX()), 0, 1};
  SeparatingAxis hint_b;
  hint_b.feature = AxisFeature::FaceB;
  hint_b.face_b = {face_towards(-Vec3::UnitX()), 0, 1};
  for (const SeparatingAxis& hint : {hint_a, hint_b}) {
    Story here = story;
    here.given(hint.feature == AxisFeature::FaceA ? "hint: A's face towards +x"
                                                  : "hint: B's face towards -x");
    const SeparatingAxis early = find_separating_axis(a, b, hint, Real(0.5));
    Story stops = here;
    stops.given("margin 0.5 m");
    require(stops.expect("the answer has the feature of the hint", early.feature == hint.feature));
    require(stops.expect_near("separation", early.separation, 1, 1e-6, "m"));
    require(stops.expect_near("axis", early.axis, Vec3::UnitX(), 1e-6));
    const SeparatingAxis full = find_separating_axis(a, b, hint, HUGE_VALF);
    Story goes_on = here;
    goes_on.given("margin: none");
    require(goes_on.expect_near("separation", full.separation, 2, 1e-6, "m"));
  }
  const SeparatingAxis unhinted = find_separating_axis(a, b, {}, Real(0.5));
  story.expect("without a hint: an axis beyond the margin", unhinted.separation > Real(0.5));
  require_best_axis(story, pair, unhinted, Real(0.5), rounding);
  story.expect("without a hint: at least one of the face queries is empty",
               !(unhinted.face_a && unhinted.face_b));
  const SeparatingAxis wide = find_separating_axis(a, b, hint_a, Real(1.5));
  story.expect_near("with a margin of 1.5 m, which x does not pass: separation", wide.separation, 2,
                    1e-6, "m");
  require_hinted_edges_first(of_other_pairs);
  require_an_empty_query(of_other_pairs);
  require_edges_beyond_the_margin(of_other_pairs);
}

GRADED_TEST(Lab4, AStaleHintIsNotBelieved, 2, "L4.4") {
  Story story("A hint says where to look first, not what is there");
  story.likely("measure the hinted face again: the bodies have moved")
      .likely("hinted edges count only while their arcs still cross")
      .likely("what the hint's separation was does not matter");
  const CrossedPair crossed = cross(crossed_shapes()[0], 1, Real(0.05));
  const PosedShape& a = crossed.pair.a;
  const PosedShape& b = crossed.pair.b;
  const HalfEdgeMesh& mesh = a.mesh();
  for (Index face = 0; face < mesh.face_count(); ++face) {
    SeparatingAxis hint;
    hint.feature = face % 2 == 0 ? AxisFeature::FaceA : AxisFeature::FaceB;
    hint.axis = Vec3::UnitX();
    hint.separation = 5;
    hint.face_a = hint.face_b = {face, 0, 5};
    const SeparatingAxis answer = find_separating_axis(a, b, hint, Real(0.01));
    Story here = about(story, crossed.pair);
    here.given("hint: face " + std::to_string(face) + ", which separated by 5 m");
    require_best_axis(here, crossed.pair, answer, Real(0.01), rounding);
  }
  for (Index e_a = 0; e_a < mesh.edge_count(); e_a += 2) {
    for (Index e_b = 0; e_b < mesh.edge_count(); e_b += 2) {
      SeparatingAxis hint;
      hint.feature = AxisFeature::Edges;
      hint.axis = Vec3::UnitX();
      hint.separation = 5;
      hint.edges = {e_a, e_b, Vec3::UnitX(), 5};
      const SeparatingAxis answer = find_separating_axis(a, b, hint, Real(0.01));
      Story here = about(story, crossed.pair);
      here.given("hint: half-edges " + std::to_string(e_a) + " of A and " + std::to_string(e_b) +
                 " of B");
      require_best_axis(here, crossed.pair, answer, Real(0.01), rounding);
    }
  }
}

}  // namespace
}  // namespace cs550::test
