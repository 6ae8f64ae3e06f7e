// L5.5: the reduction to four points.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/reduction.hpp"

namespace cs550::test {
namespace {

Story with_area_causes(Story story) {
  return story.likely("the points are picked one by one for the area they add, not by their order")
      .likely("the second is the farthest from the deepest, not from the first of the list")
      .likely("the third may lie on either side of their line: compare |area|")
      .likely("the fourth adds area outside of the triangle, beyond any of its three edges")
      .likely("anchor_a is in A's body frame, and so is the normal")
      .likely("a point that touches or overlaps counts fully: its factor is 1");
}

GRADED_TEST(Lab5, ReductionKeepsTheDeepestPoint, 1, "L5.5") {
  Random random(58);
  Story story("The deepest point is never given up");
  story.likely(
      "the first point kept is the deepest, wherever it is: the one of *smallest* separation");
  story.seed(random.seed()).given("a random ring of 5 to 14 points");
  for (int i = 0; i < 500; ++i) {
    const ContactRing ring(random, 1);
    const auto kept = reduce_manifold(ring.points, ring.normal, Real(0.1));
    const Real deepest = ring.deepest().separation;
    bool found = false;
    std::string separations;
    for (const ContactPoint& point : kept) {
      found |= point.feature == ring.deepest().feature;
      separations += (separations.empty() ? "" : ", ") + Story::show(point.separation);
    }
    Story here = story;
    here.picture([&] {
      return reduction_picture(ring.points, {kept.begin(), kept.end()}, ring.normal);
    });
    require(here.expect("separations of the points kept", found,
                        separations.empty() ? "none" : separations + " m",
                        "among them " + Story::show(deepest, "m")));
  }
}

/// Five points that touch. Of their distances from the deepest one, that of (0.9, 0) is the largest seen along
/// the normal, and that of (0.8, 0) in space. Once (0.8, 0) is kept, the last two points add more area.
void require_farthest_across_the_normal(Story story) {
  const std::vector<Vec3> places = {{0, 0, 1},
                                    {Real(0.8), 0, 0},
                                    {Real(0.9), 0, Real(0.9)},
                                    {Real(0.4), Real(0.4), Real(0.5)},
                                    {Real(0.4), Real(-0.4), Real(0.5)}};
  std::vector<ContactPoint> points(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    points[i].anchor_a = places[i];
    points[i].separation = -places[i].z();
  }
  story.given("five points that touch, at heights of 0 to 1 m along the normal")
      .likely("measure across the normal: the height along the normal is no lever arm");
  const auto kept = reduce_manifold(points, Vec3::UnitZ(), Real(0.1));
  story.picture([&] {
    return reduction_picture(points, {kept.begin(), kept.end()}, Vec3::UnitZ());
  });
  const bool found = std::any_of(kept.begin(), kept.end(), [&](const ContactPoint& point) {
    return point.anchor_a == places[2];
  });
  require(
      story.expect("the farthest point from the deepest one, across the normal, is kept", found));
}

GRADED_TEST(Lab5, ReductionKeepsTheArea, 2, "L5.5") {
  Random random(59);
  Story story = with_area_causes(Story(
      "Four points support nearly as large an area as the best four, the deepest among them"));
  story.seed(random.seed()).given("random rings of 5 to 14 points");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    require_good_reductions(story, random, size, 100);
  }
  require_farthest_across_the_normal(with_area_causes(
      Story("The second point is the farthest from the deepest, seen along the normal")));
}

/// Four points touch, the fifth is at the margin and has the longest lever arm and the largest areas.
/// Multiplied by 1/6 they are 0.19 against a distance of 1, 0.17 against a doubled area of 0.5 and
/// 0.04 against 0.1.
void require_touching_four_of_five(Story story) {
  constexpr Real margin = Real(0.01);
  const std::vector<Vec3> touching = {
      {0, 0, 0}, {1, 0, 0}, {Real(0.5), Real(0.5), 0}, {Real(0.3), Real(-0.1), 0}};
  std::vector<ContactPoint> points(5);
  points[0].anchor_a = Vec3(Real(0.5), 1, 0);
  points[0].separation = margin;
  for (std::size_t i = 0; i < touching.size(); ++i) points[i + 1].anchor_a = touching[i];
  points[1].separation = Real(-0.1) * margin;
  const auto kept = reduce_manifold(points, Vec3::UnitZ(), margin);
  story.given("five points, one of them across a gap as wide as the margin");
  story.picture([&] {
    return reduction_picture(points, {kept.begin(), kept.end()}, Vec3::UnitZ());
  });
  const auto count = std::count_if(kept.begin(), kept.end(),
                                   [](const ContactPoint& point) { return point.separation <= 0; });
  require(story.expect_equal("touching points kept", count, 4));
}

/// A point on A, with its separation as a share of the margin.
struct Candidate {
  Vec2 place;
  Real gap = 0;
};

/// Checks which of two candidates for one of the four places is kept: that across a gap of a fifth of the margin, whose
/// factor is ½, or the one that touches.
/// @param candidates the first one has a gap, the second one touches
void require_weighed(Story story, const std::vector<Candidate>& candidates, bool gap_wins) {
  constexpr Real margin = Real(0.01);
  std::vector<ContactPoint> points(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    points[i].anchor_a = Vec3(candidates[i].place.x(), candidates[i].place.y(), 0);
    points[i].separation = candidates[i].gap * margin;
  }
  const auto kept = reduce_manifold(points, Vec3::UnitZ(), margin);
  story.picture([&] {
    return reduction_picture(points, {kept.begin(), kept.end()}, Vec3::UnitZ());
  });
  const auto is_kept = [&](std::size_t i) {
    return std::any_of(kept.begin(), kept.end(), [&](const ContactPoint& point) {
      return point.anchor_a == points[i].anchor_a;
    });
  };
  require(story.expect_equal("the point across the gap is kept", is_kept(0), gap_wins));
  require(story.expect_equal("the point that touches is kept", is_kept(1), !gap_wins));
}

/// In each of the three choices the gap halves a measure of 2.4, which then exceeds 1 but not 1.3.
void require_half_at_a_fifth_of_the_margin(const Story& story) {
  constexpr Real gap = Real(0.2);
  constexpr Real deepest = Real(-0.1);
  for (const bool gap_wins : {true, false}) {
    const Real touching = gap_wins ? 1 : Real(1.3);
    Story second = story;
    second.given(
        "points on a line, at distances from the deepest one of 2.4 m across a gap of a "
        "fifth of the margin, and touching",
        touching, "m");
    require_weighed(second,
                    {{{Real(2.4), 0}, gap},
                     {{-touching, 0}},
                     {{0, 0}, deepest},
                     {{Real(-0.5), 0}},
                     {{Real(-0.25), 0}}},
                    gap_wins);
    const std::vector<Candidate> beside_the_line = {{{5, Real(2.4)}, gap}, {{5, touching}}};
    const auto with = [&](Vec2 last) {
      std::vector<Candidate> all = beside_the_line;
      all.insert(all.end(), {{{0, 0}, deepest}, {{10, 0}}, {last}});
      return all;
    };
    Story third = story;
    third.given(
        "two points 10 m apart. Beside their line: a point at 2.4 m across a gap of a fifth "
        "of the margin, and one that touches at",
        touching, "m");
    require_weighed(third, with({5, Real(-0.5)}), gap_wins);
    Story fourth = third;
    fourth.given("on the other side a third point of the triangle, at 6 m");
    require_weighed(fourth, with({5, -6}), gap_wins);
  }
}

GRADED_TEST(Lab5, BothEndsOfATouchingEdgeAreKept, 1, "L5.5") {
  Random random(61);
  Story story(
      "A body that rests on an edge keeps both ends, however far the points across the gap");
  story
      .likely(
          "a point across a gap counts less: multiply distance and areas by the header's factor")
      .likely("the factor depends on the gap as a share of the margin: s / margin")
      .likely("the factor applies in all three choices: second, third and fourth point")
      .likely(
          "the factor is ½ at a fifth of the margin: distances and areas are multiplied by it, not "
          "by its square");
  require_touching_four_of_five(story);
  require_half_at_a_fifth_of_the_margin(story);
  story.seed(random.seed()).given("two points that touch, and 4 to 8 at gaps of up to the margin");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    for (int i = 0; i < 100; ++i) {
      const Real margin = size / 50;
      const RestingEdge edge(random, size, margin);
      const auto kept = reduce_manifold(edge.points, edge.normal, margin);
      const auto touching = std::count_if(kept.begin(), kept.end(), [](const ContactPoint& point) {
        return point.separation <= 0;
      });
      Story here = story;
      here.given("points", edge.points.size()).given("margin", margin, "m");
      here.picture([&] {
        return reduction_picture(edge.points, {kept.begin(), kept.end()}, edge.normal);
      });
      require(here.expect_equal("touching points kept", touching, 2));
      require(here.expect_equal("points kept", kept.size(), 4));
    }
  }
}

/// Of points without a gap the margin changes nothing.
constexpr Real any_margin = Real(0.02);

GRADED_TEST(Lab5, FewOrCoincidingPointsAreKeptOnce, 1, "L5.5") {
  Random random(60);
  Story story("No point is invented, none is kept twice");
  story.likely("of more than four, a point that adds no area is left out: none is kept twice")
      .likely("fewer than four points may add area: do not repeat until four are kept")
      .likely("up to four points come back as they are, in their order");
  const ContactRing ring(random, 1);
  for (std::size_t count = 0; count <= 4; ++count) {
    const auto kept = reduce_manifold({ring.points.data(), count}, ring.normal, any_margin);
    Story here = story;
    here.given("points", count).when("reduced: there are not too many");
    require(here.expect_equal("points kept", kept.size(), static_cast<int>(count)));
    for (int i = 0; i < kept.size(); ++i) {
      here.expect_equal("point number " + std::to_string(i) + " is the one given at place",
                        kept[i].feature.of_a(), ring.points[i].feature.of_a());
    }
  }

  const auto doubled = [&](std::size_t places) {
    std::vector<ContactPoint> points;
    for (std::size_t i = 0; i < 6; ++i) points.push_back(ring.points[i % places]);
    return reduce_manifold(points, ring.normal, any_margin).size();
  };
  Story coinciding = story;
  coinciding.given("six points at one, two or three places").when("reduced");
  coinciding.expect_equal("points kept of one place", doubled(1), 1);
  coinciding.expect_equal("points kept of two places", doubled(2), 2);
  coinciding.expect_equal("points kept of three places", doubled(3), 3);

  std::vector<ContactPoint> in_line(6);
  for (std::size_t i = 0; i < in_line.size(); ++i) {
    in_line[i].anchor_a = Vec3(static_cast<Real>(i), 0, 0);
    in_line[i].separation = i == 2 ? Real(-0.01) : Real(-0.005);
  }
  const auto ends = reduce_manifold(in_line, Vec3::UnitZ(), any_margin);
  Story line = story;
  line.given("points at x = 0, 1, 2, 3, 4, 5 m, that at 2 m the deepest").when("reduced");
  require(line.expect_equal("points kept", ends.size(), 2));
  const auto [low, high] = std::minmax({ends[0].anchor_a.x(), ends[1].anchor_a.x()});
  line.expect_equal("the lower x kept, that of the deepest", low, Real(2));
  line.expect_equal("the higher x kept, the end farther from it", high, Real(5));
}

GRADED_TEST(Lab5, TurnedBoxKeepsFourPointsOfTheOctagon, 1, "L5.5") {
  Story story = with_area_causes(Story(
      "A box on a box, turned by 45°, touches it in an octagon: four of its corners are kept"));
  story.given("the eight contact points of a cube of 1 m on another one, turned by 45°, 1 cm deep");
  story.likely("a margin of 0 is allowed: test s > 0 first, or a factor of s / margin is 0 / 0");
  // The sides of the two squares cross at (±0.5, ±s) and (±s, ±0.5).
  const Real s = std::sqrt(Real(0.5)) - Real(0.5);
  const Real half = Real(0.5);
  const std::vector<Vec3> corners = {{half, -s, half},  {half, s, half},  {s, half, half},
                                     {-s, half, half},  {-half, s, half}, {-half, -s, half},
                                     {-s, -half, half}, {s, -half, half}};
  std::vector<ContactPoint> octagon;
  for (const Vec3& corner : corners) {
    ContactPoint point;
    point.anchor_a = corner;
    point.anchor_b = corner - Vec3(0, 0, Real(0.99));
    point.separation = Real(-0.01);
    point.feature = {FeatureId::Kind::CrossingOnA, static_cast<Index>(octagon.size()), 0};
    octagon.push_back(point);
  }
  for (const Real margin : {any_margin, Real(0)}) {
    Story here = story;
    here.given("margin", margin, "m");
    const auto kept = reduce_manifold(octagon, Vec3::UnitZ(), margin);
    here.picture([&] {
      return reduction_picture(octagon, {kept.begin(), kept.end()}, Vec3::UnitZ());
    });
    require(here.expect_equal("points", kept.size(), 4));
    for (const ContactPoint& point : kept) {
      const bool is_given =
          std::any_of(octagon.begin(), octagon.end(), [&](const ContactPoint& given) {
            return given.feature == point.feature && given.anchor_a == point.anchor_a;
          });
      require(here.expect("each point is one of the eight", is_given,
                          "a point at " + Story::show(point.anchor_a, "m"), "no new point"));
    }
    // The octagon has 0.828 m², the best four of its corners 0.586 m² (a square).
    require(
        here.expect_at_least("area", ring_area(kept, Vec3::UnitZ()), least_share * 0.586, "m²"));
  }
}

}  // namespace
}  // namespace cs550::test
