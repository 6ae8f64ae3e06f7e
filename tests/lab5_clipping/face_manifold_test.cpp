// L5.3: the positions of the points of a face manifold.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/contacts.hpp"
#include "lab5_clipping/reduction.hpp"

namespace cs550::test {
namespace {

/// The positions of clipped points are known up to the tolerance of the side planes.
constexpr Real place_tolerance = 2 * side_plane_tolerance;

Story with_clip_causes(Story story) {
  return story
      .likely(
          "the side planes go through the reference face's edges and face *out* of it: "
          "edge × normal, not normal × edge")
      .likely(
          "the incident face belongs to the other body: bring it into the reference body's frame")
      .likely("points with separation ≤ margin are kept, the others dropped");
}

Story with_anchor_causes(Story story) {
  return story
      .likely("far from the world's origin float has few digits left: clip in a body's frame")
      .likely("the manifold's normal points A → B: against the reference normal if B owns the face")
      .likely("anchor_a belongs to A and anchor_b to B, each in its own body frame")
      .likely(
          "one anchor is the clipped point, on the incident body, the other its projection onto "
          "the reference plane");
}

Story with_tangent_cause(Story story) {
  return story.likely(
      "the tangent is parallel to the reference face's first edge, in the world frame");
}

/// A box on the slab of 2 m × 2 m × 0.1 m, in a rotated and translated world.
struct BoxOnSlab {
  Pose world;
  Placed slab;
  Placed cube;

  /// @param local pose of the cube of 1 m in the slab's frame
  BoxOnSlab(Real size, const Pose& outer, const Pose& local)
      : world(outer),
        slab(scaled_shape("slab", size), outer),
        cube(scaled_shape("cube", size),
             composed(outer, {size * local.position, local.orientation})) {}

  Index top() const { return face_towards(slab.shape->mesh, Vec3::UnitZ()); }
  /// The first edge of the slab's top, in the world.
  Vec3 first_edge() const {
    const HalfEdgeMesh& mesh = slab.shape->mesh;
    return world.rotate(mesh.edge_vector(mesh.face(top()).edge));
  }
};

GRADED_TEST(Lab5, FaceOnFaceKeepsTheIncidentCorners, 2, "L5.3") {
  Story story = with_tangent_cause(with_clip_causes(
      with_anchor_causes(Story("A box on a larger face touches it with its four corners"))));
  const Real depth = Real(0.01);
  for (const Real size : {Real(1), Real(0.001), Real(1000)}) {
    const Pose outer{size * Vec3(3, -2, 5), turned(70, Vec3(1, 2, 3))};
    const Pose local{Vec3(Real(0.2), Real(-0.1), Real(0.55) - depth), turned(17, Vec3::UnitZ())};
    const BoxOnSlab scene(size, outer, local);
    std::vector<Vec3> expected;
    for (const Real x : {Real(-0.5), Real(0.5)}) {
      for (const Real y : {Real(-0.5), Real(0.5)}) {
        const Vec3 corner = local.to_world(Vec3(x, y, Real(-0.5)));
        expected.push_back(
            outer.to_world(size * Vec3(corner.x(), corner.y(), Real(0.05) - depth / 2)));
      }
    }
    Story here = story;
    here.given("a cube on a slab, turned by 17°, 1 cm deep for 1 m of side")
        .given("side", size, "m");

    const PosedShape& slab = scene.slab.body;
    const PosedShape& cube = scene.cube.body;
    const Manifold below =
        face_manifold(slab, cube, face_axis(slab, cube, AxisFeature::FaceA, scene.top()), 0);
    Story slab_first = here;
    slab_first.when("A is the slab, which owns the reference face");
    require(slab_first.expect_near("normal", below.normal, outer.rotate(Vec3::UnitZ()), 1e-5));
    require(expect_points(slab_first, slab, cube, below, expected, Real(1e-5) * size));
    slab_first.expect_near("separation", deepest_separation(below), -depth * size, 1e-5 * size,
                           "m");
    require_sound(slab_first, slab, cube, below, 3 * size);
    expect_tangent_along(slab_first, below, "the reference face's first edge", scene.first_edge());

    const Manifold above =
        face_manifold(cube, slab, face_axis(cube, slab, AxisFeature::FaceB, scene.top()), 0);
    Story cube_first = here;
    cube_first.when("A is the cube, B the slab with the reference face");
    require(cube_first.expect_near("normal", above.normal, outer.rotate(-Vec3::UnitZ()), 1e-5));
    cube_first.expect_equal("owner of the reference face is B",
                            above.reference == AxisFeature::FaceB, true);
    require(expect_points(cube_first, cube, slab, above, expected, Real(1e-5) * size));
    require_sound(cube_first, cube, slab, above, 3 * size);
    expect_tangent_along(cube_first, above, "the reference face's first edge", scene.first_edge());
  }
}

GRADED_TEST(Lab5, OverhangIsCutAtTheReferenceFace, 2, "L5.3") {
  Story story =
      with_clip_causes(Story("What hangs over the reference face is cut off at its edges"));
  const Pose outer{Vec3(-4, 1, 2), turned(-40, Vec3(2, 0, 1))};
  const auto check = [&](Story here, Real x, Real y, const std::vector<Vec3>& corners) {
    const BoxOnSlab scene(1, outer, {Vec3(x, y, Real(0.54)), Quat::Identity()});
    std::vector<Vec3> expected;
    expected.reserve(corners.size());
    for (const Vec3& corner : corners) expected.push_back(outer.to_world(corner));
    here.given("middle of the cube of 1 m above the slab of 2 m at x", x, "m").given("y", y, "m");
    const Manifold manifold = face_manifold(
        scene.slab.body, scene.cube.body,
        face_axis(scene.slab.body, scene.cube.body, AxisFeature::FaceA, scene.top()), 0);
    expect_points(here, scene.slab.body, scene.cube.body, manifold, expected, place_tolerance);
  };
  const Real left = Real(0.7);
  const Real half = Real(0.5);
  const Real height = Real(0.045);  // half-way down the overlap
  Story over_side = story;
  over_side.when("the cube hangs over one side");
  check(over_side, Real(1.2), 0,
        {Vec3(left, -half, height), Vec3(1, -half, height), Vec3(1, half, height),
         Vec3(left, half, height)});
  Story over_corner = story;
  over_corner.when("the cube hangs over a corner");
  check(
      over_corner, Real(1.2), Real(1.2),
      {Vec3(left, left, height), Vec3(1, left, height), Vec3(1, 1, height), Vec3(left, 1, height)});
}

GRADED_TEST(Lab5, PointsAboveTheMarginAreDropped, 2, "L5.3") {
  Story story = with_clip_causes(Story("Of a tilted face, the points up to the margin are kept"));
  const Real sine = Real(0.5);
  const Real cosine = std::sqrt(Real(0.75));
  const Real depth = Real(0.01);
  // The lowest edge of the cube at z = 0.05 − depth, the next edges 1 m × sin 30° higher.
  const Real middle = Real(0.05) - depth + Real(0.5) * (sine + cosine);
  const BoxOnSlab scene(1, Pose{}, {Vec3(0, 0, middle), turned(30, Vec3::UnitY())});
  const PosedShape& slab = scene.slab.body;
  const PosedShape& cube = scene.cube.body;
  const SeparatingAxis axis = face_axis(slab, cube, AxisFeature::FaceA, scene.top());

  const Real x_low = Real(0.5) * (cosine - sine);
  const Real z_low = Real(0.05) - depth / 2;
  std::vector<Vec3> points = {Vec3(x_low, Real(-0.5), z_low), Vec3(x_low, Real(0.5), z_low)};
  story.given("a cube of 1 m that stands on an edge, leaning by 30°, 1 cm deep in a slab");
  Story touching = story;
  touching.when("the margin is 0");
  expect_points(touching, slab, cube, face_manifold(slab, cube, axis, 0), points, Real(1e-5));

  const Real x_high = x_low - cosine;
  const Real z_high = Real(0.05) + (sine - depth) / 2;
  points.push_back(Vec3(x_high, Real(-0.5), z_high));
  points.push_back(Vec3(x_high, Real(0.5), z_high));
  Story speculative = story;
  speculative.when("the margin is 0.5 m, above the raised edge at 0.49 m");
  expect_points(speculative, slab, cube, face_manifold(slab, cube, axis, Real(0.5)), points,
                Real(1e-5));

  Story shy = story;
  shy.when("the margin is −2 cm, below the deepest point");
  expect_points(shy, slab, cube, face_manifold(slab, cube, axis, Real(-0.02)), {}, 0);
}

/// Checks the area of four points of the octagon in which a cube touches another one, turned on it. The contact
/// normal is along z for the lower cube, along y for the upper one and along x in the world. About the normal of
/// another frame the octagon has no area, so that rounding would select the points.
void require_area_of_an_octagon(Story story, Real degrees) {
  story.given("a cube on a cube, turned about their normal")
      .given("angle", degrees, "°")
      .given("the normal is along z for the lower cube, y for the upper one and x in the world")
      .likely("reduce_manifold() wants the normal in A's body frame, as its anchors are");
  const Pose outer{Vec3::Zero(), Quat(Real(0.5), Real(0.5), Real(0.5), Real(0.5))};
  const Pose local{Vec3(0, 0, Real(0.99)),
                   turned(degrees, Vec3::UnitZ()) * turned(-90, Vec3::UnitX())};
  const Placed lower(fixture_shape("cube"), outer);
  const Placed upper(fixture_shape("cube"), composed(outer, local));
  const Index top = face_towards(lower.shape->mesh, Vec3::UnitZ());
  const auto check = [&](const PosedShape& a, const PosedShape& b, AxisFeature feature,
                         const Vec3& normal_of_a) {
    Story here = story;
    here.given("the reference face, of the lower cube, is " + name_of(feature));
    const Manifold manifold = face_manifold(a, b, face_axis(a, b, feature, top), 0);
    require(here.expect_equal("points kept of eight", manifold.points.size(), 4));
    // The best four of its corners have 0.586 m² (a square) if it is regular, else more.
    require(here.expect_at_least("area of the points kept", ring_area(manifold.points, normal_of_a),
                                 least_share * 0.586, "m²"));
  };
  check(lower.body, upper.body, AxisFeature::FaceA, Vec3::UnitZ());
  check(upper.body, lower.body, AxisFeature::FaceB, Vec3::UnitY());
}

GRADED_TEST(Lab5, AnchorsLieOnBothBodies, 2, "L5.3") {
  Random random(54);
  Story story = with_anchor_causes(
      Story("Every point has an anchor on each body, a separation apart along the normal"));
  story.seed(random.seed());
  const char* names[] = {"cube", "box_1x2x3", "prism6", "regular_tetrahedron", "dodecahedron"};
  int points = 0;
  for (int i = 0; i < 400; ++i) {
    const Real size = i % 3 == 0 ? Real(1e-3) : i % 3 == 1 ? Real(1) : Real(1e3);
    const std::string name_a = names[random.integer(0, 4)];
    const std::string name_b = names[random.integer(0, 4)];
    // So far from the origin that positions are rounded to 3e-4 sizes. Body frames are exact.
    const Pose pose_a{Vec3(4000 * size, -3000 * size, 0), random.orientation()};
    const Vec3 offset = size * random.real(Real(0.3), Real(1)) * random.unit_vector();
    const Placed a(scaled_shape(name_a, size), pose_a);
    const Placed b(scaled_shape(name_b, size), {pose_a.position + offset, random.orientation()});
    const bool by_a = i % 2 == 0;
    const PosedShape& owner = by_a ? a.body : b.body;
    const Vec3 towards_other = owner.pose.unrotate(by_a ? offset : Vec3(-offset));
    const SeparatingAxis axis =
        face_axis(a.body, b.body, by_a ? AxisFeature::FaceA : AxisFeature::FaceB,
                  face_towards(owner.mesh(), towards_other));
    const Manifold manifold = face_manifold(a.body, b.body, axis, 0);
    points += manifold.points.size();
    Story here = story;
    here.given("A is a " + name_a)
        .given("B is a " + name_b)
        .given(by_a ? "the reference face is A's" : "the reference face is B's");
    here.given("size", size, "m").when("they overlap");
    require(here.expect_near("normal", manifold.normal, axis.axis, 1e-5));
    require_sound(here, a.body, b.body, manifold, 3 * size);
  }
  story.expect_at_least("points seen in all", points, 400);
  for (const Real degrees : {Real(45), Real(50), Real(55)}) {
    require_area_of_an_octagon(story, degrees);
  }
}

GRADED_TEST(Lab5, UnmergedFacesLoseCorners, 1, "L5.3") {
  Story story = with_clip_causes(
      Story("Clipped against a triangle, half a box's contact polygon is lost: why lab 2 merges"));
  const auto contact_area = [&](const char* below) {
    const Placed a(fixture_shape(below), Pose{});
    const Placed b(fixture_shape("cube"), {Vec3(0, 0, Real(0.99)), Quat::Identity()});
    const Index top = face_towards(a.shape->mesh, Vec3::UnitZ());
    const Manifold manifold =
        face_manifold(a.body, b.body, face_axis(a.body, b.body, AxisFeature::FaceA, top), 0);
    std::vector<Point> points;
    for (const ContactPoint& point : manifold.points) points.push_back(on_b(b.body, point));
    return area_of(points, Point::UnitZ());
  };
  story.given("a cube of 1 m on top of another, aligned, 1 cm deep");
  Story merged = story;
  merged.when("the lower cube has six square faces");
  merged.expect_near("area of the contact polygon", contact_area("cube"), 1, 1e-3, "m²");
  Story unmerged = story;
  unmerged.when("the lower cube has twelve triangles");
  unmerged.expect_near("area of the contact polygon", contact_area("triangulated_cube"), 0.5, 1e-3,
                       "m²");
}

}  // namespace
}  // namespace cs550::test
