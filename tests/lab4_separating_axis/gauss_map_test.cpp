// L4.1: whether two arcs of the unit sphere cross.
#include <cs550/graded_test.hpp>

#include <utility>

#include "cs550/separating_axis.hpp"
#include "drawing/gauss_map_drawing.hpp"
#include "helpers/picture.hpp"
#include "helpers/random.hpp"
#include "helpers/require.hpp"
#include "helpers/story.hpp"
#include "lab4_separating_axis/gauss_map.hpp"

namespace cs550::test {
namespace {

Story with_arc_causes(Story story) {
  return story.likely("the ends of each arc must lie on both sides of the other arc's plane")
      .likely("two great circles meet twice: the arcs must lie in the same hemisphere")
      .likely("with edge directions in place of the cross products, take both with the same sign")
      .likely(
          "compare with 0: arcs between the faces of a fine mesh are short, and their products "
          "tiny");
}

/// The two arcs, seen from their side of the sphere.
std::string arcs_picture(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, bool cross) {
  drawing::View view;
  view.toward_eye = a + b + c + d;
  const std::string title = "Do these arcs cross? Expected: ";
  return side_by_side(title + (cross ? "yes, got: no" : "no, got: yes"),
                      {drawing::Scene{drawing::draw_arc_pair(a, b, c, d), view}},
                      "What lies on the far side of the sphere is pale.");
}

/// A second point of the sphere, less than a half circle away.
Vec3 arc_end(Random& random, const Vec3& begin) {
  const Vec3 sideways = any_perpendicular(begin);
  const Real turn = random.real(-pi, pi);
  const Vec3 away = std::cos(turn) * sideways + std::sin(turn) * begin.cross(sideways);
  const Real length = random.real(Real(0.05), Real(2.6));
  return std::cos(length) * begin + std::sin(length) * away;
}

/// An arc with a point in its middle third. @param along the unit tangent at that point
std::pair<Vec3, Vec3> arc_through(Random& random, const Vec3& point, const Vec3& along,
                                  Real length) {
  const Real before = random.real(Real(1) / 3, Real(2) / 3) * length;
  const auto at = [&](Real angle) {
    return Vec3(std::cos(angle) * point + std::sin(angle) * along);
  };
  return {at(-before), at(length - before)};
}

/// Faces of a mesh of a thousand faces have normals a few degrees apart.
void require_short_arcs_cross(Random& random, const Story& story) {
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = random.unit_vector();
    const Vec3 east = any_perpendicular(point);
    const Vec3 north = point.cross(east);
    const Real turn = random.real(Real(0.5), pi - Real(0.5));
    const auto length = [&] { return random.real(Real(0.01), Real(0.1)); };
    const auto [a, b] = arc_through(random, point, east, length());
    const auto [c, d] =
        arc_through(random, point, std::cos(turn) * east + std::sin(turn) * north, length());
    Story here = story;
    here.given("short arcs, a", a).given("b", b).given("c", c).given("d", d);
    require(here.expect("the arcs cross", is_minkowski_face(a, b, c, d)));
  }
}

GRADED_TEST(Lab4, ArcsThatCrossMakeAMinkowskiFace, 3, "L4.1") {
  Random random(41);
  Story story = with_arc_causes(Story("Two arcs make a Minkowski face if and only if they cross"));
  story.seed(random.seed()).when("is_minkowski_face(a, b, c, d)");
  int crossing = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 a = random.unit_vector();
    const Vec3 b = arc_end(random, a);
    const Vec3 c = random.unit_vector();
    const Vec3 d = arc_end(random, c);
    const Crossing expected =
        crossing_by_lengths(a.cast<double>(), b.cast<double>(), c.cast<double>(), d.cast<double>());
    if (expected == Crossing::TooCloseToTell) continue;
    if (expected == Crossing::Yes) ++crossing;
    Story here = story;
    here.given("a", a).given("b", b).given("c", c).given("d", d);
    here.picture([&] { return arcs_picture(a, b, c, d, expected == Crossing::Yes); });
    const bool got = is_minkowski_face(a, b, c, d);
    require(here.expect_equal("the arcs cross", got, expected == Crossing::Yes));
  }
  // 354 ± 18 over all seeds: the bound holds for every salt of a course.
  story.expect_at_least("pairs that cross, so that both answers are asked for", crossing, 250);
  require_short_arcs_cross(random, story);
}

GRADED_TEST(Lab4, ArcsThatTouchOrLieOppositeDoNotCross, 3, "L4.1") {
  Story story = with_arc_causes(
      Story("Arcs that only touch, and arcs on opposite sides of the sphere, do not cross"));
  story.likely("strictly on both sides: < 0 and not <= 0");
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  const Vec3 up = Vec3(0, 1, 1).normalized();
  const Vec3 down = Vec3(0, 1, -1).normalized();
  const Vec3 left = Vec3(1, 1, 0).normalized();
  const Vec3 right = Vec3(-1, 1, 0).normalized();
  const struct {
    const char* what;
    Vec3 a, b, c, d;
    bool crosses;
  } cases[] = {
      {"a cross about +y", left, right, up, down, true},
      {"a cross about +y, one arc the other way round", left, right, down, up, true},
      {"the second arc about -y instead", left, right, -up, -down, false},
      {"the first arc about -y instead", -left, -right, up, down, false},
      {"a common end", x, y, y, z, false},
      {"the same arc twice", x, y, x, y, false},
      {"one ends on the other", x, y, left, Vec3(1, 1, 1).normalized(), false},
      {"two pieces of one circle that overlap", x, right, left, y, false},
      {"far apart", x, left, -x, up, false},
  };
  for (const auto& arcs : cases) {
    Story here = story;
    here.given(arcs.what).given("a", arcs.a).given("b", arcs.b);
    here.given("c", arcs.c).given("d", arcs.d);
    here.picture([&] { return arcs_picture(arcs.a, arcs.b, arcs.c, arcs.d, arcs.crosses); });
    const bool got = is_minkowski_face(arcs.a, arcs.b, arcs.c, arcs.d);
    require(here.expect_equal("the arcs cross", got, arcs.crosses));
  }
}

}  // namespace
}  // namespace cs550::test
