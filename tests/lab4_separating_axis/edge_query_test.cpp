// L4.3: cross products of edges as axes.
#include <cs550/graded_test.hpp>

#include "drawing/gauss_map_drawing.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/picture.hpp"
#include "lab4_separating_axis/axis_oracle.hpp"
#include "lab4_separating_axis/crossed_shapes.hpp"

namespace cs550::test {
namespace {

Story with_edge_causes(Story story) {
  return story.likely("the arcs of B on the Gauss map are those of its *negated* normals")
      .likely("the axis points out of A: turn it until n·(sum of the normals beside A's edge) > 0")
      .likely("the separation is signed, n·(p_B - p_A): a distance is never negative")
      .likely("both edges, and the normals beside them, must be in one frame")
      .likely("an edge has two half-edges: one of them, the even one, is enough")
      .likely("the inner loop counts on its own edge, not that of the outer loop")
      .likely("the axis is wanted in the world and of unit length");
}

/// The edges found, with their axis and their arcs on the Gauss maps.
std::string edge_query_picture(const TestPair& pair, const EdgeQuery& got) {
  SeparatingAxis axis;
  axis.feature = AxisFeature::Edges;
  axis.edges = got;
  axis.axis = got.axis;
  axis.separation = got.separation;
  drawing::Drawing bodies = drawing::draw_axis(pair.a, pair.b, axis, drawing::Role::Got);
  bodies.title = "Got: " + drawing::feature_text(axis);
  drawing::Drawing maps = drawing::draw_gauss_maps(pair.a, pair.b, {}, axis);
  maps.title = "Their arcs: do they cross, and is the axis there?";
  drawing::View onto_crossing;
  onto_crossing.toward_eye = got.axis + Vec3(Real(0.1), Real(-0.2), Real(0.3));
  return side_by_side("Edges that give the axis",
                      {drawing::Scene{bodies, {}}, drawing::Scene{maps, onto_crossing}});
}

/// Checks that an answer is an axis of these two edges with the reported separation.
void require_edge_axis(Story& here, const TestPair& pair, const EdgeQuery& answer) {
  require(here.expect_index("half-edge of A", answer.edge_a, pair.a.mesh().edge_count()));
  require(here.expect_index("half-edge of B", answer.edge_b, pair.b.mesh().edge_count()));
  require(here.expect_equal("remainder of edge_a over 2", answer.edge_a % 2, 0));
  require(here.expect_equal("remainder of edge_b over 2", answer.edge_b % 2, 0));
  const ExactBody a = pair.exact_a();
  const ExactBody b = pair.exact_b();
  const Vec3d axis = answer.axis.cast<double>();
  const Vec3d along_a = a.edges[answer.edge_a / 2];
  const Vec3d along_b = b.edges[answer.edge_b / 2];
  const double sine = along_a.cross(along_b).norm();
  const double tolerance = rounding * double{pair.larger_radius()};
  require(here.expect_near("length of the axis", axis.norm(), 1, 1e-5));
  require(here.expect_at_least("sine between the edges", sine, 0.999 * double{parallel_sine}));
  // An edge between vertices of the world has a direction error of 1e-6 and more, which a cross
  // product divides by the sine.
  require(here.expect_near("axis along A's edge", axis.dot(along_a), 0, rounding / sine));
  require(here.expect_near("axis along B's edge", axis.dot(along_b), 0, rounding / sine));
  require(here.expect_near("separation along the axis, A to B", answer.separation,
                           separation_along(a, b, axis.normalized()), tolerance / sine, "m"));
}

GRADED_TEST(Lab4, EdgeQueryMatchesBruteForceOverAllPairs, 5, "L4.3") {
  Random random(43);
  Story story = with_edge_causes(
      Story("Of all pairs of edges whose arcs cross the answer has the largest separation"));
  story.seed(random.seed()).when("query_edge_directions(A, B)");
  story.likely("a point is turned and moved, a direction is only turned: A is not at the origin");
  const std::vector<ShapePtr> shapes = small_shapes();
  int overlapping = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 place = random.point_in_box({3, 3, 3});
    TestPair pair = random_pair(random, shapes, place);
    if (i % 2 == 1) pair.approach(Real(0.3));  // deep, where centroids are misleading
    const EdgeQuery answer = query_edge_directions(pair.a, pair.b);
    const ExactEdges exact = exact_edges(pair);
    Story here = about(story, pair);
    here.picture([&] { return edge_query_picture(pair, answer); });
    require(here.expect("some arcs cross", static_cast<bool>(answer)));
    require_edge_axis(here, pair, answer);
    const double tolerance = rounding * double{pair.larger_radius()};
    require(here.expect_at_least("separation against brute force", answer.separation,
                                 exact.clear - tolerance, "m"));
    require(here.expect_at_most("separation against brute force", answer.separation,
                                exact.any + tolerance, "m"));
    if (exact.any < 0) ++overlapping;
  }
  story.expect_at_least("pairs with negative separation, so that both signs occur", overlapping,
                        40);
  // 44 ± 5 over all seeds: the bound holds for every salt of a course.
  story.expect_at_least("pairs with positive separation", 200 - overlapping, 20);
}

GRADED_TEST(Lab4, ParallelEdgesAreSkipped, 3, "L4.3") {
  Random random(44);
  Story story("Edges count as parallel by the sine between them, whatever their lengths");
  story.seed(random.seed()).when("query_edge_directions() of boxes that are nearly aligned");
  story.likely("compare |e_A x e_B| with parallel_sine·|e_A|·|e_B|, not with a constant")
      .likely("a cross product of nearly nothing, normalised, is an axis of rounding errors")
      .likely("the inner loop counts on its own edge, not that of the outer loop");
  const Quat rolled(Eigen::AngleAxis<Real>(pi / 4, Vec3::UnitX()));
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    const ShapePtr box = scaled_shape("box_1x2x3", size);
    for (int i = 0; i < 100; ++i) {
      // All three edge directions of each box occur. Half of the pairs are at less than the
      // limiting angle, the others at more.
      const Real angle = i % 2 == 0 ? Real(4e-4) : Real(4e-3);
      const Quat turn = rotation_exp(angle * random.unit_vector()) * rolled;
      const Vec3 place = size * Vec3(0, 0, Real(2.5));
      const TestPair pair{{box.get(), {Vec3::Zero(), Quat::Identity()}},
                          {box.get(), {place, turn}},
                          "a box above a box, rolled by 45 degrees and a little"};
      Story here = about(story, pair);
      here.given("size", size, "m").given("a little", angle, "rad");
      const EdgeQuery answer = query_edge_directions(pair.a, pair.b);
      if (answer) require_edge_axis(here, pair, answer);
      const ExactEdges exact = exact_edges(pair);
      if (exact.clear > -HUGE_VAL) {
        require(here.expect("an answer where arcs cross", static_cast<bool>(answer)));
      }
    }
  }
}

GRADED_TEST(Lab4, CrossedEdgesAtAnySize, 4, "L4.3") {
  Story story =
      with_edge_causes(Story("Two bodies that cross edge over edge separate by their "
                             "distance less both heights, along the vertical"));
  story.likely("a tolerance in metres that fits a box of 1 m is wrong for one of 12 mm");
  for (const Real size : {Real(1e-3), Real(0.012), Real(1), Real(1e3)}) {
    for (const CrossedShape& shape : crossed_shapes()) {
      for (const Real overlap_share : {Real(0.05), Real(-0.05)}) {
        const CrossedPair crossed = cross(shape, size, overlap_share);
        const EdgeQuery answer = query_edge_directions(crossed.pair.a, crossed.pair.b);
        Story here = about(story, crossed.pair);
        here.given("size", size, "m");
        here.picture([&] { return edge_query_picture(crossed.pair, answer); });
        require(here.expect("some arcs cross", static_cast<bool>(answer)));
        const double tolerance = rounding * double{size};
        require(
            here.expect_near("separation", answer.separation, crossed.separation, tolerance, "m"));
        require(here.expect_near("axis", answer.axis, Vec3::UnitZ(), 1e-5));
      }
    }
  }
}

}  // namespace
}  // namespace cs550::test
