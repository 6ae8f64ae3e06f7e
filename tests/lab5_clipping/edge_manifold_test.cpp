// L5.4: two crossing edges.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/segments.hpp"

namespace cs550::test {
namespace {

Story with_edge_causes(Story story) {
  return story.likely("the anchors are the closest points of the two *segments*: clamp to 0 … 1")
      .likely("after clamping one parameter the other one must be computed again")
      .likely(
          "the edges are in two body frames: bring them into one, and each anchor back to its own")
      .likely("the separation is n·(point on B − point on A): negative in penetration")
      .likely("the tangent is parallel to A's edge, in the world frame");
}

GRADED_TEST(Lab5, CrossedEdgesMeetWhereTheyCross, 3, "L5.4") {
  Story story = with_edge_causes(Story("Two crossed edges touch in one point, where they cross"));
  const Real half = Real(0.5);
  const Real peak = std::sqrt(half);  // from the middle of the cube to an edge
  const Real depth = Real(0.02);
  for (const Real size : {Real(1), Real(0.001), Real(1000)}) {
    for (const Real shift : {Real(-0.3), Real(0), Real(0.4)}) {
      const ShapePtr cube = scaled_shape("cube", size);
      const Pose outer{size * Vec3(40, -30, 20), turned(110, Vec3(1, -1, 2))};
      const Vec3 above(shift, -shift / 2, 2 * peak - depth);
      // A's upper edge runs along y, B's lower edge along x.
      const Placed a(cube, composed(outer, {Vec3::Zero(), turned(45, Vec3::UnitY())}));
      const Placed b(cube, composed(outer, {size * above, turned(45, Vec3::UnitX())}));
      const HalfEdgeMesh& mesh = cube->mesh;
      const Index edge_a = edge_between(mesh, vertex_at(mesh, size * Vec3(-half, -half, half)),
                                        vertex_at(mesh, size * Vec3(-half, half, half)));
      const Index edge_b = edge_between(mesh, vertex_at(mesh, size * Vec3(-half, -half, -half)),
                                        vertex_at(mesh, size * Vec3(half, -half, -half)));
      const SeparatingAxis axis = edge_axis(a.body, b.body, edge_a, edge_b);
      const Manifold manifold = edge_manifold(a.body, b.body, axis);

      Story here = story;
      here.given("two cubes, one's upper edge across the other's lower one, 2 cm deep for 1 m");
      here.given("side", size, "m")
          .given("B moved along A's edge by " + Story::show(-shift / 2 * size, "m"));
      require(expect_points(here, a.body, b.body, manifold,
                            {outer.to_world(size * Vec3(0, -shift / 2, peak - depth / 2))},
                            Real(1e-5) * size));
      here.expect_near("normal", manifold.normal, outer.rotate(Vec3::UnitZ()), 1e-5);
      here.expect_near("separation", manifold.points[0].separation, -depth * size, 1e-5 * size,
                       "m");
      here.expect_equal("reference feature of the manifold", name_of(manifold.reference),
                        name_of(AxisFeature::Edges));
      const FeatureId id = manifold.points[0].feature;
      const std::string what = "its name (half-edge / 2): ";
      here.expect_equal(what + "kind", static_cast<int>(id.kind()),
                        static_cast<int>(FeatureId::Kind::Edges));
      here.expect_equal(what + "edge of A", id.of_a(), edge_a / 2);
      here.expect_equal(what + "edge of B", id.of_b(), edge_b / 2);
      require_sound(here, a.body, b.body, manifold, 3 * size);
      expect_tangent_along(here, manifold, "A's edge",
                           a.body.pose.rotate(mesh.edge_vector(edge_a)));
    }
  }
}

GRADED_TEST(Lab5, ClosestPointsStayOnTheSegments, 2, "L5.4") {
  Random random(57);
  Story story = with_edge_causes(Story("The anchors are the closest points of the two segments"));
  story.seed(random.seed()).given("random edges of two boxes, most of which do not cross");
  const ShapePtr shapes[] = {fixture_shape("cube"), fixture_shape("box_1x2x3")};
  for (int i = 0; i < 1000; ++i) {
    const Pose pose_a{random.point_in_box(Vec3(1, 1, 1)), random.orientation()};
    const Pose pose_b{random.point_in_box(Vec3(1, 1, 1)), random.orientation()};
    const Placed a(shapes[random.integer(0, 1)], pose_a);
    const Placed b(shapes[random.integer(0, 1)], pose_b);
    const Index edge_a = random.integer(0, 23);
    const Index edge_b = random.integer(0, 23);
    const Vec3 along_a = pose_a.rotate(a.shape->mesh.edge_vector(edge_a)).normalized();
    const Vec3 along_b = pose_b.rotate(b.shape->mesh.edge_vector(edge_b)).normalized();
    if (along_a.cross(along_b).norm() < Real(0.05)) continue;  // near-parallel edges give no axis
    const SeparatingAxis axis = edge_axis(a.body, b.body, edge_a, edge_b);
    const Manifold manifold = edge_manifold(a.body, b.body, axis);
    require_closest_points(story, a.body, b.body, axis, manifold, 4);
  }
}

}  // namespace
}  // namespace cs550::test
