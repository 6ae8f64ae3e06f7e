// L5.1: Sutherland & Hodgman's table, corner by corner.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/pictures.hpp"
#include "lab5_clipping/polygons.hpp"

namespace cs550::test {
namespace {

constexpr ClipEdge along_plane{ClipEdge::Source::Reference, 7};

/// The number of corners of the clipped square where it lies wholly behind the plane.
int corners_of_untouched_square(Story story) {
  story.given("the unit square").when("clipped to x ≤ 2: front → front, four times");
  return clip_polygon(unit_square(), {Vec3::UnitX(), 2}, along_plane).size();
}

Story with_table_causes(Story story) {
  const int corners = corners_of_untouched_square(story);
  if (corners == 3) {
    return story.likely(
        "the loop leaves out an edge: a polygon has as many edges as corners, and the last one "
        "leads back to the first corner");
  }
  if (corners == 5) {
    return story.likely(
        "the loop visits an edge twice: a polygon has only as many edges as corners");
  }
  return story
      .likely(
          "\"front\" is the side that is kept: distance ≤ 0, the plane's normal points out of it")
      .likely("behind → front emits two corners, the intersection and then the second end")
      .likely("the intersection is at the share d_a / (d_a − d_b) of the way from a to b")
      .likely("the last corner's neighbour is the first one");
}

Story with_plane_causes(Story story) {
  return story.likely("a corner on the plane (distance exactly 0) is kept")
      .likely("an intersection is emitted only between ends strictly on opposite sides")
      .likely("the corner on the plane came out twice: once as itself and once as an intersection");
}

Story with_name_causes(Story story) {
  return story
      .likely("a new corner lies on one of the polygon's edges and on the plane: one name each")
      .likely("`in` is the edge that ends in the corner, `out` the one that leaves it")
      .likely("a corner on the plane in which the outline leaves ends with the plane's edge")
      .likely(
          "a polygon that the plane does not cross keeps its names, even with a side on the plane");
}

/// The name of a feature, such as "incident 3".
std::string name(const ClipEdge& edge) {
  return (edge.source == ClipEdge::Source::Incident ? "incident " : "reference ") +
         std::to_string(edge.edge);
}

/// The names of a corner's features, "in, out".
std::string names_at(const ClipPolygon& polygon, const Vec3& place) {
  for (const ClipVertex& corner : polygon) {
    if ((corner.point - place).norm() < Real(1e-6)) {
      return "in " + name(corner.in) + ", out " + name(corner.out);
    }
  }
  return "no corner there";
}

/// Clips a polygon and checks the remaining corners.
void expect_clipped(Story& story, const ClipPolygon& polygon, const Plane& plane,
                    const std::vector<Vec3>& expected, Real tolerance = 0, SourceLine at = {}) {
  const ClipPolygon got = clip_polygon(polygon, plane, along_plane);
  story.picture([&] { return clip_picture(polygon, plane, expected, got); });
  expect_corners(story, got, expected, tolerance, at);
}

GRADED_TEST(Lab5, ClippingFollowsTheTable, 4, "L5.1") {
  Story story = with_table_causes(Story("A clipped polygon has the corners that the table emits"));
  const ClipPolygon triangle = polygon_of({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)});

  Story untouched = story;
  untouched.given("the unit square").when("clipped to x ≤ 2: front → front, four times");
  expect_clipped(untouched, unit_square(), {Vec3::UnitX(), 2},
                 {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});

  Story halved = story;
  halved.given("the unit square").when("clipped to x ≤ 0.25: all four rows of the table");
  expect_clipped(halved, unit_square(), {Vec3::UnitX(), Real(0.25)},
                 {Vec3(0, 0, 0), Vec3(Real(0.25), 0, 0), Vec3(Real(0.25), 1, 0), Vec3(0, 1, 0)});

  Story one_corner_off = story;
  one_corner_off.given("the triangle (0, 0), (4, 0), (0, 4)").when("clipped to x ≤ 1");
  expect_clipped(one_corner_off, triangle, {Vec3::UnitX(), 1},
                 {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 3, 0), Vec3(0, 4, 0)});

  Story two_corners_off = story;
  two_corners_off.given("the triangle (0, 0), (4, 0), (0, 4)").when("clipped to x ≥ 3");
  expect_clipped(two_corners_off, triangle, {-Vec3::UnitX(), -3},
                 {Vec3(3, 0, 0), Vec3(4, 0, 0), Vec3(3, 1, 0)});

  Story last_edge_cut = story;
  last_edge_cut.given("the triangle (0, 0), (4, 0), (0, 4)")
      .when("clipped to y ≤ 1, across the edge from the last corner to the first");
  expect_clipped(last_edge_cut, triangle, {Vec3::UnitY(), 1},
                 {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(3, 1, 0), Vec3(0, 1, 0)});

  Story swallowed = story;
  swallowed.given("the unit square").when("clipped to x ≤ −1: behind → behind, four times");
  expect_clipped(swallowed, unit_square(), {Vec3::UnitX(), -1}, {});
}

GRADED_TEST(Lab5, CornersOnThePlaneAreKeptOnce, 3, "L5.1") {
  Story story = with_plane_causes(Story("A corner exactly on the plane is kept, and only once"));
  const Vec3 east(1, 0, 0), north(0, 1, 0), west(-1, 0, 0), south(0, -1, 0);
  const ClipPolygon diamond = polygon_of({east, north, west, south});

  Story side = story;
  side.given("the unit square").when("clipped to x ≤ 1, where it has a side");
  expect_clipped(side, unit_square(), {Vec3::UnitX(), 1},
                 {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});

  Story other_side = story;
  other_side.given("the unit square").when("clipped to x ≤ 0: all but one side is cut off");
  expect_clipped(other_side, unit_square(), {Vec3::UnitX(), 0}, {Vec3(0, 0, 0), Vec3(0, 1, 0)});

  Story halved = story;
  halved.given("the diamond (±1, 0), (0, ±1)").when("clipped to x ≤ 0, through two corners");
  expect_clipped(halved, diamond, {Vec3::UnitX(), 0}, {north, west, south});

  Story through_one = story;
  through_one.given("the triangle (0, 0), (4, 0), (0, 4)")
      .when("clipped to x ≥ y, through the corner (0, 0) and a side");
  const Real half = std::sqrt(Real(0.5));
  expect_clipped(through_one, polygon_of({Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}),
                 {Vec3(-half, half, 0), 0}, {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(2, 2, 0)},
                 Real(1e-6));

  Story touched = story;
  touched.given("the diamond (±1, 0), (0, ±1)").when("clipped to x ≥ 1, where it has a corner");
  expect_clipped(touched, diamond, {-Vec3::UnitX(), -1}, {east});
}

GRADED_TEST(Lab5, EmptyPolygonsStayEmptyAndOthersUntouched, 1, "L5.1") {
  Story story = with_table_causes(Story("A plane that does not meet a polygon changes nothing"));
  Story met = story;
  met.given("the unit square").when("clipped to x ≤ 0.25, which meets it");
  require(expect_corners(
      met, clip_polygon(unit_square(), {Vec3::UnitX(), Real(0.25)}, along_plane),
      {Vec3(0, 0, 0), Vec3(Real(0.25), 0, 0), Vec3(Real(0.25), 1, 0), Vec3(0, 1, 0)}));

  Story empty = story;
  empty.given("a polygon without corners").when("clipped");
  expect_clipped(empty, ClipPolygon(), {Vec3::UnitX(), 0}, {});

  Random random(51);
  const ClipPolygon square = unit_square();
  Story untouched = story;
  untouched.seed(random.seed()).given("the unit square").when("clipped by planes beyond it");
  for (int i = 0; i < 100; ++i) {
    const Plane beyond{random.unit_vector(), Real(1.5)};
    const ClipPolygon got = clip_polygon(square, beyond, along_plane);
    require(expect_corners(untouched, got, unit_square_corners()));
    for (const ClipVertex& corner : got) {
      const ClipVertex& given = *std::find_if(
          square.begin(), square.end(),
          [&](const ClipVertex& candidate) { return candidate.point == corner.point; });
      untouched.expect_equal("in of a corner", name(corner.in), name(given.in));
      untouched.expect_equal("out of a corner", name(corner.out), name(given.out));
    }
  }
}

GRADED_TEST(Lab5, ClippedCornersAreNamedByTheirEdges, 3, "L5.1") {
  Story story = with_name_causes(Story("The two edges that meet in a corner name it"));
  story.given("the unit square, its sides incident 0 to 3 from (0, 0) on");

  Story cut = story;
  cut.when("clipped to x ≤ 0.25 along reference 7");
  const ClipPolygon part = clip_polygon(unit_square(), {Vec3::UnitX(), Real(0.25)}, along_plane);
  cut.expect_equal("corner (0, 0)", names_at(part, Vec3(0, 0, 0)),
                   std::string("in incident 3, out incident 0"));
  cut.expect_equal("corner (0.25, 0)", names_at(part, Vec3(Real(0.25), 0, 0)),
                   std::string("in incident 0, out reference 7"));
  cut.expect_equal("corner (0.25, 1)", names_at(part, Vec3(Real(0.25), 1, 0)),
                   std::string("in reference 7, out incident 2"));

  Story diagonal = story;
  diagonal.when("clipped to x ≤ y along reference 7, through two corners");
  const Real half = std::sqrt(Real(0.5));
  const ClipPolygon triangle = clip_polygon(unit_square(), {Vec3(half, -half, 0), 0}, along_plane);
  diagonal.expect_equal("corner (0, 0), where the outline leaves",
                        names_at(triangle, Vec3(0, 0, 0)),
                        std::string("in incident 3, out reference 7"));
  diagonal.expect_equal("corner (1, 1), where it comes back", names_at(triangle, Vec3(1, 1, 0)),
                        std::string("in reference 7, out incident 2"));

  Story touched = story;
  touched.when("clipped to x ≤ 1 along reference 7, where it has a side");
  const ClipPolygon whole = clip_polygon(unit_square(), {Vec3::UnitX(), 1}, along_plane);
  touched.expect_equal("corner (1, 0), where the side begins", names_at(whole, Vec3(1, 0, 0)),
                       std::string("in incident 0, out incident 1"));
  touched.expect_equal("corner (1, 1), where it ends", names_at(whole, Vec3(1, 1, 0)),
                       std::string("in incident 1, out incident 2"));

  Random random(52);
  for (int i = 0; i < 200; ++i) {
    ClipPolygon polygon = unit_square();
    for (Index plane = 0; plane < 5; ++plane) {
      const Real angle = random.real(0, 2 * pi);
      const Vec3 normal(std::cos(angle), std::sin(angle), 0);
      const Real offset = normal.dot(Vec3(Real(0.5), Real(0.5), 0)) + random.real(0, Real(0.7));
      polygon = clip_polygon(polygon, {normal, offset}, {ClipEdge::Source::Reference, plane});
    }
    Story chain = story;
    chain.seed(random.seed()).when("clipped by five planes that leave its middle");
    for (int k = 0; k < polygon.size(); ++k) {
      const ClipVertex& next = polygon[(k + 1) % polygon.size()];
      require(chain.expect_equal("`in` of a corner, against `out` of the one before it",
                                 name(next.in), name(polygon[k].out)));
    }
    require(chain.expect_at_least("corners left", polygon.size(), 3));
  }
}

}  // namespace
}  // namespace cs550::test
