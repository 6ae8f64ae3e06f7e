// L5.3: the feature ids of a face manifold, and their persistence.
#include <cs550/graded_test.hpp>

#include <algorithm>

#include "lab5_clipping/contacts.hpp"

namespace cs550::test {
namespace {

using Kind = FeatureId::Kind;

Story with_feature_causes(Story story) {
  return story
      .likely(
          "two incident edges are an incident vertex, one of each kind a crossing, two reference "
          "edges a corner of the reference face")
      .likely("of_a names an element of A, whoever owns the reference face")
      .likely("crossings name edges: half-edge / 2, so that both halves have one name")
      .likely("the side planes lie side_plane_tolerance outside of the edges, not on them");
}

std::vector<std::uint32_t> sorted_ids(const Manifold& manifold) {
  std::vector<std::uint32_t> ids;
  for (const ContactPoint& point : manifold.points) ids.push_back(point.feature.bits);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::string names_of(const Manifold& manifold) {
  std::string list;
  for (const ContactPoint& point : manifold.points) {
    list += (list.empty() ? "" : ", ") + name_of(point.feature);
  }
  return list.empty() ? "none" : list;
}

/// The feature id of the point with its anchor on B at a position in B's frame.
std::string feature_at(const Manifold& manifold, const Vec3& place, bool on_body_b) {
  for (const ContactPoint& point : manifold.points) {
    const Vec3& anchor = on_body_b ? point.anchor_b : point.anchor_a;
    if ((anchor - place).norm() < Real(1e-3)) return name_of(point.feature);
  }
  return "no point there";
}

/// The edge between two vertices, as feature ids count them.
Index edge_number(const HalfEdgeMesh& mesh, const Vec3& from, const Vec3& to) {
  return edge_between(mesh, vertex_at(mesh, from), vertex_at(mesh, to)) / 2;
}

GRADED_TEST(Lab5, FeaturesNameWhatMeets, 2, "L5.3") {
  Story story = with_feature_causes(Story("A contact point is named after the features that meet"));
  const Placed slab(fixture_shape("slab"), Pose{});
  const Placed cube(fixture_shape("cube"),
                    {Vec3(Real(1.2), Real(1.2), Real(0.54)), Quat::Identity()});
  const HalfEdgeMesh& below = slab.shape->mesh;
  const HalfEdgeMesh& above = cube.shape->mesh;
  const Index top = face_towards(below, Vec3::UnitZ());
  const Index bottom = face_towards(above, -Vec3::UnitZ());
  const Real half = Real(0.5);
  const Real t = Real(0.05);
  const Vec3 inner_corner(-half, -half, -half);
  const Index vertex = vertex_at(above, inner_corner);
  const Index slab_corner = vertex_at(below, Vec3(1, 1, t));
  const Index slab_side = edge_number(below, Vec3(1, -1, t), Vec3(1, 1, t));
  const Index cube_side = edge_number(above, inner_corner, Vec3(half, -half, -half));
  // The slab's corner (1, 1) and its side x = 1 in the cube's frame.
  const Vec3 at_slab_corner(Real(-0.2), Real(-0.2), -half);
  const Vec3 at_crossing(Real(-0.2), -half, -half);
  story.given("a cube over the corner of a slab that is larger");

  const Manifold slab_first = face_manifold(
      slab.body, cube.body, face_axis(slab.body, cube.body, AxisFeature::FaceA, top), 0);
  Story on_a = story;
  on_a.when("A is the slab, with the reference face");
  on_a.expect_equal("cube's corner on the slab's face", feature_at(slab_first, inner_corner, true),
                    name_of({Kind::VertexOnFaceA, top, vertex}));
  on_a.expect_equal("cube's edge over the slab's edge", feature_at(slab_first, at_crossing, true),
                    name_of({Kind::CrossingOnA, slab_side, cube_side}));
  on_a.expect_equal("slab's corner under the cube's face",
                    feature_at(slab_first, at_slab_corner, true),
                    name_of({Kind::CornerOfFaceA, slab_corner, bottom}));

  const Manifold cube_first = face_manifold(
      cube.body, slab.body, face_axis(cube.body, slab.body, AxisFeature::FaceB, top), 0);
  Story on_b = story;
  on_b.when("B is the slab, with the reference face");
  on_b.expect_equal("cube's corner on the slab's face", feature_at(cube_first, inner_corner, false),
                    name_of({Kind::VertexOnFaceB, vertex, top}));
  on_b.expect_equal("cube's edge over the slab's edge", feature_at(cube_first, at_crossing, false),
                    name_of({Kind::CrossingOnB, cube_side, slab_side}));
  on_b.expect_equal("slab's corner under the cube's face",
                    feature_at(cube_first, at_slab_corner, false),
                    name_of({Kind::CornerOfFaceB, bottom, slab_corner}));
}

GRADED_TEST(Lab5, AlignedStackKeepsItsFeatures, 1, "L5.3") {
  Random random(55);
  Story story = with_feature_causes(
      Story("Boxes stacked edge to edge touch with the same four vertices, whatever the rounding"));
  story.seed(random.seed()).given("a cube of 1 m on another one, aligned up to 1e-6 m");
  const ShapePtr cube = fixture_shape("cube");
  const Index top = face_towards(cube->mesh, Vec3::UnitZ());
  for (int i = 0; i < 200; ++i) {
    const Quat yaw = turned(random.real(0, 360), Vec3::UnitZ());
    const Vec3 below(random.real(-9, 9), random.real(-9, 9), 0);
    const Vec3 jitter = random.point_in_box(Vec3::Constant(Real(1e-6)));
    const Placed a(cube, {below, yaw});
    const Placed b(cube, {below + Vec3(0, 0, Real(0.999)) + jitter, yaw});
    const Manifold manifold =
        face_manifold(a.body, b.body, face_axis(a.body, b.body, AxisFeature::FaceA, top), 0);
    require(story.expect_equal("points", manifold.points.size(), 4));
    for (const ContactPoint& point : manifold.points) {
      const bool is_vertex = point.feature.kind() == Kind::VertexOnFaceA;
      require(story.expect("each point is a vertex of the upper cube", is_vertex,
                           name_of(point.feature), "VertexOnFaceA " + std::to_string(top) + "/…"));
      require(story.expect_near("its anchor, against that vertex", point.anchor_b,
                                cube->mesh.vertex(point.feature.of_b()), 1e-5, "m"));
    }
  }
}

GRADED_TEST(Lab5, FeaturesSurviveSmallMotion, 1, "L5.3") {
  Random random(56);
  Story story = with_feature_causes(
      Story("A small motion changes where the points are, not what they are called"));
  story.seed(random.seed());
  const ShapePtr slab = fixture_shape("slab");
  const ShapePtr cube = fixture_shape("cube");
  const Index top = face_towards(slab->mesh, Vec3::UnitZ());
  // Cases in which no corner is near an edge: on the face, over a side, over a corner.
  const Vec3 places[] = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, -1, 0)};
  for (int i = 0; i < 300; ++i) {
    Vec3 place = places[i % 3] + random.point_in_box(Vec3(Real(0.2), Real(0.2), 0));
    place.z() = Real(0.54);
    const Quat yaw = turned(i % 3 == 0 ? random.real(0, 360) : 0, Vec3::UnitZ());
    const Vec3 shift = Real(1e-4) * random.unit_vector();
    const Quat turn = rotation_exp(Real(1e-4) * random.unit_vector());
    const Placed a(slab, Pose{});
    const Placed before(cube, {place, yaw});
    const Placed after(cube, {place + shift, turn * yaw});
    const SeparatingAxis axis = face_axis(a.body, before.body, AxisFeature::FaceA, top);
    const Manifold first = face_manifold(a.body, before.body, axis, 0);
    const Manifold second = face_manifold(a.body, after.body, axis, 0);
    Story here = story;
    here.given("a cube of 1 m on a slab at " + Story::show(place, "m"))
        .when("it moves by 1e-4 m and 1e-4 rad");
    require(here.expect_equal("points before", first.points.size(), 4));
    require(here.expect("the names afterwards", sorted_ids(first) == sorted_ids(second),
                        names_of(second), names_of(first)));
    const std::vector<std::uint32_t> ids = sorted_ids(first);
    require(here.expect("the names differ", std::adjacent_find(ids.begin(), ids.end()) == ids.end(),
                        names_of(first), "no name twice"));
  }
}

}  // namespace
}  // namespace cs550::test
