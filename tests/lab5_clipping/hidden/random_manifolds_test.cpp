// L5.3 to L5.6 with other numbers: sizes, places and seeds.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/contact_polygon.hpp"
#include "lab5_clipping/overlapping_pairs.hpp"
#include "lab5_clipping/reduction.hpp"
#include "lab5_clipping/segments.hpp"

namespace cs550::test {
namespace {

GRADED_TEST(Lab5, FaceManifoldMatchesBruteForce, 3, "L5.3") {
  Random random(153);
  Story story("The points of a face manifold are corners of the clipped incident face");
  story.seed(random.seed())
      .likely("the side planes face out of the reference face: edge × normal")
      .likely("the incident face belongs to the other body")
      .likely("of_a and anchor_a belong to A, whoever owns the reference face");
  const char* names[] = {"cube", "box_1x2x3", "prism6", "dodecahedron", "corner_tetrahedron"};
  int compared = 0;
  for (int i = 0; i < 600; ++i) {
    const Placed a(fixture_shape(names[random.integer(0, 4)]),
                   {Vec3::Zero(), random.orientation()});
    const Vec3 offset = random.real(Real(0.3), Real(1.2)) * random.unit_vector();
    const Placed b(fixture_shape(names[random.integer(0, 4)]), {offset, random.orientation()});
    const bool by_a = i % 2 == 0;
    const PosedShape& owner = by_a ? a.body : b.body;
    const PosedShape& other = by_a ? b.body : a.body;
    const Vec3 towards_other = owner.pose.unrotate(by_a ? offset : Vec3(-offset));
    const Index face = face_towards(owner.mesh(), towards_other);
    const SeparatingAxis axis =
        face_axis(a.body, b.body, by_a ? AxisFeature::FaceA : AxisFeature::FaceB, face);
    const ContactPolygon polygon(owner, by_a ? axis.face_a : axis.face_b, other);
    if (polygon.ambiguous) continue;
    const Manifold manifold = face_manifold(a.body, b.body, axis, 0);
    Story here = story;
    here.given(by_a ? "the reference face is A's" : "the reference face is B's");
    here.given("corners of the clipped face below the reference plane", polygon.corners.size());
    const int expected = static_cast<int>(std::min<std::size_t>(4, polygon.corners.size()));
    require(here.expect_equal("points", manifold.points.size(), expected));
    for (const ContactPoint& point : manifold.points) {
      const Point on_incident = by_a ? on_b(b.body, point) : on_a(a.body, point);
      require(here.expect_at_most("distance of a point from the nearest of these corners",
                                  polygon.distance_to_nearest_corner(on_incident),
                                  polygon.tolerance, "m"));
    }
    ++compared;
  }
  story.expect_at_least("manifolds compared", compared, 300);
}

GRADED_TEST(Lab5, DepthHoldsAtAnySizeAndPlace, 3, "L5.6") {
  Random random(161);
  Story story("From 1 mm to 1 km, and far away, bodies that overlap touch as deep as they overlap");
  story.seed(random.seed())
      .likely("a tolerance in metres: every tolerance is a share of the smaller radius")
      .likely("world coordinates far from the origin have few digits left: clip in a body frame")
      .likely(
          "an edge's separation is compared with the face query's, not with what clipping left");
  ReferenceCount seen{};
  for (const Real size : {Real(1e-3), Real(0.05), Real(20), Real(1e3)}) {
    std::vector<ShapePtr> shapes;
    for (const char* name : {"cube", "box_0.4x1x2", "prism3", "pyramid4", "hull16"}) {
      shapes.push_back(scaled_shape(name, size));
    }
    Story here = story;
    here.given("size", size, "m").given("distance from the origin", 5000 * size, "m");
    for (int i = 0; i < 300; ++i) {
      const OverlappingPair pair(random, shapes, size * Vec3(3000, -4000, 0));
      require_depth(here, pair.a.body, pair.b.body, pair.axis, seen);
    }
  }
}

GRADED_TEST(Lab5, OtherRingsKeepTheirArea, 1, "L5.5") {
  Random random(159);
  Story story(
      "Four points support nearly as large an area as the best four, the deepest among them");
  story.seed(random.seed())
      .likely("the fourth adds area outside of the triangle, beyond any of its three edges");
  for (const Real size : {Real(0.02), Real(50)}) {
    require_good_reductions(story, random, size, 100);
  }
}

GRADED_TEST(Lab5, SegmentsOfAnySizeKeepTheirClosestPoints, 2, "L5.4") {
  Random random(157);
  Story story("The anchors are the closest points of the two segments, from 1 mm to 1 km");
  story.seed(random.seed())
      .likely("after clamping one parameter the other one must be computed again")
      .likely(
          "a determinant is compared with a fixed number: it shrinks with the fourth power of "
          "the size");
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    const Placed a(scaled_shape("box_1x2x3", size), {Vec3::Zero(), random.orientation()});
    for (int i = 0; i < 300; ++i) {
      const Vec3 offset = size * random.point_in_box(Vec3(2, 2, 2));
      const Placed b(scaled_shape("cube", size), {offset, random.orientation()});
      const Index edge_a = random.integer(0, 23);
      const Index edge_b = random.integer(0, 23);
      const SeparatingAxis axis = edge_axis(a.body, b.body, edge_a, edge_b);
      const Vec3 along_a = a.body.pose.rotate(a.shape->mesh.edge_vector(edge_a)).normalized();
      const Vec3 along_b = b.body.pose.rotate(b.shape->mesh.edge_vector(edge_b)).normalized();
      if (along_a.cross(along_b).norm() < Real(0.05)) continue;
      Story here = story;
      here.given("size", size, "m");
      const Manifold manifold = edge_manifold(a.body, b.body, axis);
      require_closest_points(here, a.body, b.body, axis, manifold, 4 * size);
    }
  }
}

}  // namespace
}  // namespace cs550::test
