// L4.2: face normals as axes.
#include <cs550/graded_test.hpp>

#include "drawing/gauss_map_drawing.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/picture.hpp"
#include "lab4_separating_axis/axis_oracle.hpp"

namespace cs550::test {
namespace {

Story with_face_causes(Story story) {
  return story.likely("B's vertex is the deepest behind the face: the support in direction -n")
      .likely("B's vertices are in B's frame: bring the direction there, or the vertices here")
      .likely("the distance of the vertex from the face's plane, with its sign")
      .likely("the *largest* of these distances is the answer, even if all are negative");
}

/// The face of largest separation beside the one found, each with the deepest vertex of B.
std::string face_query_picture(const TestPair& pair, const FaceQuery& got) {
  const auto deepest = [&](Index face) {
    FaceQuery query{face, 0, HUGE_VALF};
    for (Index v = 0; v < pair.b.mesh().vertex_count(); ++v) {
      const Real distance = pair.a.plane(face).distance(pair.b.vertex(v));
      if (distance < query.separation) query = {face, v, distance};
    }
    return query;
  };
  FaceQuery best = deepest(0);
  for (Index f = 1; f < pair.a.mesh().face_count(); ++f) {
    const FaceQuery other = deepest(f);
    if (other.separation > best.separation) best = other;
  }
  const auto drawn = [&](const FaceQuery& query, drawing::Role role) {
    SeparatingAxis axis;
    axis.feature = AxisFeature::FaceA;
    axis.face_a = query;
    axis.separation = query.separation;
    const bool exists = query.face >= 0 && query.face < pair.a.mesh().face_count();
    if (exists) axis.axis = pair.a.plane(query.face).normal;
    drawing::Drawing drawing = drawing::draw_axis(pair.a, pair.b, axis, role);
    drawing.title = "face " + std::to_string(query.face) + " of A";
    return drawing;
  };
  const Vec3 normal = pair.a.plane(best.face).normal;
  drawing::View view;
  view.up = normal;
  view.toward_eye = any_perpendicular(normal) + Real(0.3) * normal;
  return expected_beside_got("The face of A that separates most, its normal upward",
                             drawn(best, drawing::Role::Expected), drawn(got, drawing::Role::Got),
                             view);
}

GRADED_TEST(Lab4, FaceQueryMatchesBruteForce, 4, "L4.2") {
  Random random(42);
  Story story = with_face_causes(
      Story("The best face has the largest, over faces, of the smallest distance of B's vertices"));
  story.seed(random.seed()).when("query_face_directions(A, B)");
  story.likely("into A's frame, subtract x_A before you turn the point: A is not at the origin");
  const std::vector<ShapePtr> shapes = small_shapes();
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 place = random.point_in_box({3, 3, 3});
    const TestPair pair = random_pair(random, shapes, place);
    const FaceQuery answer = query_face_directions(pair.a, pair.b);
    Story here = about(story, pair);
    here.picture([&] { return face_query_picture(pair, answer); });
    require(here.expect_index("face of A", answer.face, pair.a.mesh().face_count()));
    require(here.expect_index("vertex of B", answer.vertex, pair.b.mesh().vertex_count()));
    const double tolerance = rounding * double{pair.larger_radius()};
    const double best = best_separations(pair.exact_a(), pair.exact_b()).face_a;
    require(here.expect_near("separation", answer.separation, best, tolerance, "m"));
    const Real distance = pair.a.plane(answer.face).distance(pair.b.vertex(answer.vertex));
    require(
        here.expect_near("distance of that vertex from that face", distance, best, tolerance, "m"));
    if (best > 0) ++apart;
  }
  story.expect_at_least("pairs that a face separates, so that both signs occur", apart, 30);
  story.expect_at_least("pairs that no face separates", 300 - apart, 30);
}

GRADED_TEST(Lab4, FaceQueryOfBoxesIsKnown, 3, "L4.2") {
  Story story = with_face_causes(Story("Boxes whose separations can be read off a sketch"));
  story.given("A: a cube of 1 m at the origin").given("B: a box of 1 x 2 x 3 m, not turned");
  story.likely("for B's faces swap the arguments: no sign changes inside");
  const ShapePtr cube = fixture_shape("cube");
  const ShapePtr box = fixture_shape("box_1x2x3");
  const struct {
    Vec3 position;
    double separation;
    Vec3 normal;
  } cases[] = {
      {{0, 0, Real(1.75)}, -0.25, Vec3::UnitZ()},
      {{0, 0, Real(2.25)}, 0.25, Vec3::UnitZ()},
      {{Real(-0.75), 0, 0}, -0.25, -Vec3::UnitX()},
      {{0, 3, 1}, 1.5, Vec3::UnitY()},
  };
  for (const auto& expected : cases) {
    const PosedShape a{cube.get(), {Vec3::Zero(), Quat::Identity()}};
    const PosedShape b{box.get(), {expected.position, Quat::Identity()}};
    Story here = story;
    here.given("position of B", expected.position, "m");
    const FaceQuery of_a = query_face_directions(a, b);
    const FaceQuery of_b = query_face_directions(b, a);
    require(here.expect_index("best face of A", of_a.face, a.mesh().face_count()));
    require(here.expect_index("best face of B", of_b.face, b.mesh().face_count()));
    require(here.expect_near("separation, faces of A", of_a.separation, expected.separation, 1e-6,
                             "m"));
    require(here.expect_near("separation, faces of B", of_b.separation, expected.separation, 1e-6,
                             "m"));
    require(here.expect_near("normal of the best face of A", a.plane(of_a.face).normal,
                             expected.normal, 1e-6));
    require(here.expect_near("normal of the best face of B", b.plane(of_b.face).normal,
                             -expected.normal, 1e-6));
  }
}

GRADED_TEST(Lab4, FirstOfEqualFacesWins, 1, "L4.2") {
  Story story("Of equally good faces the first one wins");
  story.likely("only a strictly larger separation takes over: > and not >=");
  story.given("two cubes of 1 m in the same place: every face has separation -1 m");
  const ShapePtr cube = fixture_shape("cube");
  const PosedShape body{cube.get(), {Vec3::Zero(), Quat::Identity()}};
  const FaceQuery answer = query_face_directions(body, body);
  story.expect_equal("best face", answer.face, Index{0});
  story.expect_near("separation", answer.separation, -1, 1e-6, "m");
}

}  // namespace
}  // namespace cs550::test
