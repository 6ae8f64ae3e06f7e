// L5.6: the choice of the manifold.
#include <cs550/graded_test.hpp>

#include "lab5_clipping/contact_polygon.hpp"
#include "lab5_clipping/overlapping_pairs.hpp"
#include "lab5_clipping/reduction.hpp"

namespace cs550::test {
namespace {

Story with_choice_causes(Story story) {
  return story
      .likely(
          "an edge's separation is compared with the *face query's*, not with what clipping left")
      .likely("the preference makes it harder for the edges: edges > face + preference")
      .likely("a preference as a factor of the depth grows with it; it is a share of the radius")
      .likely("of two faces the one of larger separation is the reference face")
      .likely(
          "clipping lost the deepest point: fall back to the edges, then to the deepest vertex");
}

/// Checks the depth if nothing but A's best face is known. It need not separate best of all, so the deepest vertex
/// may be beyond a side of it.
void require_depth_of_face(Story story, const PosedShape& a, const PosedShape& b,
                           const FaceQuery& face) {
  SeparatingAxis axis;
  axis.feature = AxisFeature::FaceA;
  axis.face_a = face;
  axis.axis = a.plane(face.face).normal;
  axis.separation = face.separation;
  const Manifold manifold = build_manifold(a, b, axis, 0);
  story.given("an axis with a query of A's faces only, of separation " +
              Story::show(face.separation, "m"));
  story.picture([&] { return manifold_picture(a, b, manifold, axis.axis); });
  require(story.expect_near("deepest point", static_cast<double>(deepest_separation(manifold)),
                            static_cast<double>(face.separation),
                            static_cast<double>(depth_tolerance(a, b)), "m"));
}

/// Clipping a face of 32 corners by the sides of another one leaves 64 corners. They lie on a circle of radius
/// cos(π/32) / cos(π/64), and four of them form a square, which is the largest quadrilateral in it.
void require_four_of_many_corners(Story story) {
  constexpr Real depth = Real(0.01);
  const ShapePtr prism = fixture_shape("prism32");
  const PosedShape a{prism.get(), Pose{}};
  const PosedShape b{prism.get(), {Vec3(0, 0, 1 - depth), turned(Real(180) / 32, Vec3::UnitZ())}};
  story.given("a prism of 32 sides on another one, turned by half of a side's angle, 1 cm deep")
      .likely("a face may have max_face_vertices corners, and the clipped polygon twice as many");
  const Index top = face_towards(prism->mesh, Vec3::UnitZ());
  const Manifold manifold = build_manifold(a, b, face_axis(a, b, AxisFeature::FaceA, top), 0);
  require(story.expect_equal("points", manifold.points.size(), 4));
  std::vector<Point> places;
  for (const ContactPoint& point : manifold.points) {
    require(story.expect_near("separation", point.separation, -depth, 1e-6, "m"));
    places.push_back(middle(a, b, point));
  }
  const double radius = std::cos(M_PI / 32) / std::cos(M_PI / 64);
  require(story.expect_at_least("area", area_of(places, Point::UnitZ()),
                                least_share * 2 * radius * radius, "m²"));
}

GRADED_TEST(Lab5, OverlappingBodiesReportTheirDepth, 3, "L5.6") {
  Random random(61);
  Story story = with_choice_causes(
      Story("Bodies that overlap always touch, as deep as their separating axis says"));
  story.seed(random.seed()).when("build_manifold() with margin 0");
  std::vector<ShapePtr> shapes;
  for (const char* name : {"cube", "box_1x2x3", "prism6", "corner_tetrahedron", "sliver", "needle",
                           "dodecahedron", "hull8", "hull16"}) {
    shapes.push_back(fixture_shape(name));
  }
  ReferenceCount seen{};
  for (int i = 0; i < 3000; ++i) {
    const OverlappingPair pair(random, shapes, Vec3::Zero());
    require_depth(story, pair.a.body, pair.b.body, pair.axis, seen);
    require_depth_of_face(story, pair.a.body, pair.b.body, pair.axis.face_a);
  }
  for (const AxisFeature kind : {AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
    story.expect_at_least("manifolds of each kind (faces of A, of B, edges)",
                          seen[static_cast<std::size_t>(kind)], 300);
  }
  require_four_of_many_corners(story);
}

/// Only the edges are known, as after an early out by the edges of the hint.
void require_edges_without_faces(Story here, const PosedShape& a, const PosedShape& b,
                                 SeparatingAxis axis) {
  axis.feature = AxisFeature::Edges;
  axis.face_a = {};
  axis.face_b = {};
  here.given("the queries of both bodies' faces are empty")
      .likely("if both face queries are empty, there is no face to choose: the edges are used");
  const Manifold manifold = build_manifold(a, b, axis, 0);
  require(here.expect_equal("points", manifold.points.size(), 1));
  require(here.expect_equal("winner", name_of(manifold.reference), name_of(AxisFeature::Edges)));
}

GRADED_TEST(Lab5, EdgesAreComparedWithTheFaceQuery, 2, "L5.6") {
  Story story = with_choice_causes(Story(
      "Edges that separate best win, though clipping leaves a point that is hardly deep at all"));
  struct Case {
    Vec3 position;
    Vec3 axis;
    Real degrees;
  };
  const Case cases[] = {
      {Vec3(Real(0.66), Real(1.49), Real(1.57)), Vec3(Real(-0.44), Real(0.94), Real(0.47)), 63},
      {Vec3(Real(-1.69), Real(0.76), Real(-1.17)), Vec3(Real(0.26), Real(-0.9), Real(-0.5)), 151},
      {Vec3(Real(1.4), Real(0.04), Real(0.04)), Vec3(Real(-0.77), Real(0.34), Real(0.22)), 161},
      {Vec3(Real(0.3), Real(-1.17), Real(-1.2)), Vec3(Real(0.34), Real(-0.76), Real(-0.11)), 168}};
  for (const Case& one : cases) {
    const Placed a(fixture_shape("cube"), Pose{});
    const Placed b(fixture_shape("box_1x2x3"), {one.position, turned(one.degrees, one.axis)});
    const SeparatingAxis axis = find_separating_axis(a.body, b.body, {}, 0);
    Story here = story;
    here.given("a box of 1 m × 2 m × 3 m, 10 to 40 cm deep in a cube of 1 m, at " +
               Story::show(one.position, "m"));
    ReferenceCount seen{};
    require_depth(here, a.body, b.body, axis, seen);
    here.expect_equal("manifolds made by edges", seen[static_cast<std::size_t>(AxisFeature::Edges)],
                      1);
    require_edges_without_faces(here, a.body, b.body, axis);
  }
}

/// An edge query is empty if no arcs cross, as for aligned boxes. After an early out only A's face
/// is known, or only B's if that was in the hint.
void require_face_without_edges(Story here, const PosedShape& a, const PosedShape& b,
                                SeparatingAxis axis) {
  SeparatingAxis only_b = axis;
  only_b.feature = AxisFeature::FaceB;
  only_b.face_a = {};
  only_b.edges = {};
  axis.edges = {};
  here.given("an empty edge query: its separation is 0, its edges are no_index")
      .likely("an empty query has no separation: test it before you compare");
  require(here.expect_equal("winner", name_of(build_manifold(a, b, axis, 0).reference),
                            name_of(AxisFeature::FaceA)));
  axis.face_b = {};
  Story face_of_a = here;
  face_of_a.given("an empty query of B's faces, too");
  require(face_of_a.expect_equal("winner", name_of(build_manifold(a, b, axis, 0).reference),
                                 name_of(AxisFeature::FaceA)));
  here.given("an empty query of A's faces, too");
  require(here.expect_equal("winner", name_of(build_manifold(a, b, only_b, 0).reference),
                            name_of(AxisFeature::FaceB)));
}

/// Faces of nearly equal separation, and edges that are no better. @param axis two faces of equal separation
void require_steady_face(Story story, const PosedShape& a, const PosedShape& b,
                         SeparatingAxis axis) {
  story.likely("faces within tie_tolerance of each other tie, and axis.feature decides")
      .likely("of two bodies the smaller radius gives the tolerance");
  axis.edges.separation = axis.face_a.separation;
  const Real tie = tie_tolerance * std::min(a.shape->radius, b.shape->radius);
  for (const AxisFeature feature : {AxisFeature::FaceA, AxisFeature::FaceB, AxisFeature::Edges}) {
    for (const Real ties : {Real(-2), Real(-0.5), Real(0.5), Real(2)}) {
      SeparatingAxis changed = axis;
      changed.feature = feature;
      changed.face_b.separation += ties * tie;
      const bool tied = std::abs(ties) < 1;
      const bool b_wins = tied ? feature == AxisFeature::FaceB : ties > 0;
      Story here = story;
      here.given("axis.feature names " + name_of(feature))
          .given("lead of B's face, in tie_tolerance × the smaller radius", ties);
      require(here.expect_equal("winner", name_of(build_manifold(a, b, changed, 0).reference),
                                name_of(b_wins ? AxisFeature::FaceB : AxisFeature::FaceA)));
    }
  }
}

GRADED_TEST(Lab5, FacesArePreferredNearATie, 1, "L5.6") {
  Story story = with_choice_causes(Story(
      "Edges replace a face only if they are better by edge_preference × the smaller radius"));
  for (const Real size : {Real(1), Real(1e-3), Real(1e3)}) {
    for (const Real depth : {Real(0.001), Real(0.1), Real(0.4)}) {
      for (const Real of_slab : {Real(1), Real(10)}) {
        const Placed a(scaled_shape("slab", of_slab * size), Pose{});
        const Placed b(
            scaled_shape("cube", size),
            {size * Vec3(0, 0, Real(0.05) * of_slab + Real(0.5) - depth), Quat::Identity()});
        const Index top = face_towards(a.shape->mesh, Vec3::UnitZ());
        const Index bottom = face_towards(b.shape->mesh, -Vec3::UnitZ());
        SeparatingAxis axis = face_axis(a.body, b.body, AxisFeature::FaceA, top);
        axis.face_b = face_axis(a.body, b.body, AxisFeature::FaceB, bottom).face_b;
        axis.edges = {0, 9, Vec3::UnitZ(), 0};  // any two edges: only their separation counts
        const Real preference = edge_preference * b.shape->radius;

        const auto built_with = [&](Real advantage, AxisFeature feature) {
          SeparatingAxis changed = axis;
          changed.edges.separation = axis.face_a.separation + advantage;
          changed.feature = feature;
          return build_manifold(a.body, b.body, changed, size).reference;
        };
        Story here = story;
        here.given("a cube flat on a slab")
            .given("side of the cube", size, "m")
            .given("side of the slab", 2 * of_slab * size, "m")
            .given("depth", depth * size, "m");
        here.expect_equal("winner if the edges are better by half the preference",
                          name_of(built_with(Real(0.5) * preference, AxisFeature::Edges)),
                          name_of(AxisFeature::FaceA));
        here.expect_equal("winner if the edges are better by twice the preference",
                          name_of(built_with(2 * preference, AxisFeature::Edges)),
                          name_of(AxisFeature::Edges));
        here.expect_equal("winner if both faces are equal and axis.feature is FaceB",
                          name_of(built_with(0, AxisFeature::FaceB)), name_of(AxisFeature::FaceB));
        require_face_without_edges(here, a.body, b.body, axis);
        require_steady_face(here, a.body, b.body, axis);
      }
    }
  }
}

/// Whether the points may be a selection of more, which L5.5 tests. Decided without the code under test.
bool may_be_reduced(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                    const Manifold& manifold) {
  if (manifold.reference == AxisFeature::Edges) return false;
  const bool on_a = manifold.reference == AxisFeature::FaceA;
  const ContactPolygon polygon(on_a ? a : b, on_a ? axis.face_a : axis.face_b, on_a ? b : a);
  return polygon.ambiguous || polygon.corners.size() > max_manifold_points;
}

GRADED_TEST(Lab5, SwappedBodiesMirrorTheManifold, 2, "L5.6") {
  Random random(62);
  Story story = with_choice_causes(Story("Which body is called A changes no contact point"));
  story.seed(random.seed()).likely("the normal points A → B: swapped bodies turn it round");
  const std::vector<ShapePtr> shapes = {fixture_shape("cube"), fixture_shape("box_1x2x3"),
                                        fixture_shape("regular_tetrahedron"),
                                        fixture_shape("hull8")};
  int compared = 0;
  int points_compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const OverlappingPair pair(random, shapes, Vec3::Zero());
    const PosedShape& a = pair.a.body;
    const PosedShape& b = pair.b.body;
    const Real smaller = std::min(a.shape->radius, b.shape->radius);
    const Real between_faces = pair.axis.face_a.separation - pair.axis.face_b.separation;
    if (std::abs(between_faces) < Real(0.01) * smaller) continue;  // a tie: both are correct
    const Manifold manifold = build_manifold(a, b, pair.axis, 0);
    const Manifold mirrored = build_manifold(b, a, find_separating_axis(b, a, {}, 0), 0);
    Story here = story;
    here.given("the points as A and B").when("the arguments are swapped");
    require(here.expect("both manifolds have points",
                        !manifold.points.empty() && !mirrored.points.empty()));
    require(here.expect_near("normal", mirrored.normal, -manifold.normal, 1e-4));
    require(here.expect_near("deepest separation", deepest_separation(mirrored),
                             deepest_separation(manifold), 1e-5 * smaller, "m"));
    if (!may_be_reduced(a, b, pair.axis, manifold)) {
      std::vector<Vec3> places;
      for (const ContactPoint& point : manifold.points) {
        places.push_back(middle(a, b, point).cast<Real>());
      }
      require(expect_points(here, b, a, mirrored, places, Real(1e-4) * smaller));
      ++points_compared;
    }
    ++compared;
  }
  story.expect_at_least("pairs compared", compared, 500);
  story.expect_at_least("pairs with all points compared", points_compared, 300);
}

/// Checks the point of a cube's deepest vertex, which is above the plane of the slab's top but beyond its sides.
/// @param slab at the origin, its top 5 cm below the cube
void require_vertex_on_face(Story here, const PosedShape& slab, const PosedShape& cube,
                            AxisFeature owner) {
  const bool slab_is_a = owner == AxisFeature::FaceA;
  const PosedShape& a = slab_is_a ? slab : cube;
  const PosedShape& b = slab_is_a ? cube : slab;
  const Index top = face_towards(slab.mesh(), Vec3::UnitZ());
  const SeparatingAxis axis = face_axis(a, b, owner, top);
  const Index vertex = (slab_is_a ? axis.face_a : axis.face_b).vertex;
  here.when(slab_is_a ? "A is the slab, with the reference face, and the margin is 10 cm"
                      : "B is the slab, with the reference face, and the margin is 10 cm");
  Story counted = with_choice_causes(here);
  const Manifold manifold = build_manifold(a, b, axis, Real(0.1));
  require(counted.expect_equal("points", manifold.points.size(), 1));

  here.likely("the deepest vertex is named with the query's face: VertexOnFaceA or VertexOnFaceB")
      .likely(
          "the deepest vertex is the anchor on its own body, its projection the one on the other")
      .likely(
          "the deepest vertex has the normal of a face manifold: turned round if B owns the face");
  const ContactPoint& point = manifold.points[0];
  const Vec3 corner = cube.mesh().vertex(vertex);
  const Vec3 above = cube.pose.to_world(corner);
  here.expect_near("separation", point.separation, 0.05, 1e-6, "m");
  here.expect_near("normal", manifold.normal, Vec3(0, 0, slab_is_a ? Real(1) : Real(-1)), 1e-6);
  here.expect_near("anchor on the cube", slab_is_a ? point.anchor_b : point.anchor_a, corner, 1e-6,
                   "m");
  here.expect_near("anchor on the slab", slab_is_a ? point.anchor_a : point.anchor_b,
                   Vec3(above.x(), above.y(), Real(0.05)), 1e-6, "m");
  here.expect_equal("name of the point", name_of(point.feature),
                    name_of(slab_is_a ? FeatureId(FeatureId::Kind::VertexOnFaceA, top, vertex)
                                      : FeatureId(FeatureId::Kind::VertexOnFaceB, vertex, top)));
}

/// Checks the points of a cube that leans outward beside a slab: clipping cuts off its lowest edge, the query's.
void require_clipped_points(Story here, const PosedShape& slab) {
  const Real sine = Real(0.5);
  const Real cosine = std::sqrt(Real(0.75));
  const Real half = Real(0.5);
  const Real overhang = Real(0.1);
  const Real gap = Real(0.01);
  const Vec3 edge(1 + overhang, 0, Real(0.05) + gap);
  const Vec3 edge_to_middle(-half * (cosine - sine), 0, half * (cosine + sine));
  const Placed cube(fixture_shape("cube"), {edge + edge_to_middle, turned(30, Vec3::UnitY())});
  here.given(
          "the cube moved and turned by 30°, its lowest edge 10 cm beside the slab, 1 cm above it")
      .when("the margin is 1 m")
      .likely(
          "bodies that are apart keep their clipped points, though the query's vertex is closer");
  const Index top = face_towards(slab.mesh(), Vec3::UnitZ());
  const SeparatingAxis axis = face_axis(slab, cube.body, AxisFeature::FaceA, top);
  // Half-way between the slab and the lower face, which rises by tan 30°: at the slab's side and at its other end.
  const Real at_side = Real(0.05) + (gap + overhang * sine / cosine) / 2;
  const Real at_end = Real(0.05) + (gap + sine) / 2;
  const Real end = 1 + overhang - cosine;
  expect_points(here, slab, cube.body, build_manifold(slab, cube.body, axis, 1),
                {Vec3(1, -half, at_side), Vec3(1, half, at_side), Vec3(end, -half, at_end),
                 Vec3(end, half, at_end)},
                2 * side_plane_tolerance);
}

GRADED_TEST(Lab5, SeparatedBodiesTouchUpToTheMargin, 1, "L5.6") {
  Story story("Bodies apart have contact points up to the margin, and none beyond it");
  const Placed a(fixture_shape("slab"), Pose{});
  const Placed b(fixture_shape("cube"), {Vec3(0, 0, Real(0.6)), Quat::Identity()});
  const Index top = face_towards(a.shape->mesh, Vec3::UnitZ());
  const SeparatingAxis axis = face_axis(a.body, b.body, AxisFeature::FaceA, top);
  story.given("a cube 5 cm above a slab");

  Story within = with_choice_causes(story);
  within.when("the margin is 10 cm");
  const Manifold manifold = build_manifold(a.body, b.body, axis, Real(0.1));
  require(within.expect_equal("points", manifold.points.size(), 4));
  within.expect_near("separation", deepest_separation(manifold), 0.05, 1e-6, "m");
  within.expect_near("normal", manifold.normal, Vec3::UnitZ(), 1e-6);

  // Fast bodies that approach sideways must not be missed by clipping.
  const Placed aside(fixture_shape("cube"),
                     {Vec3(Real(1.6), Real(1.6), Real(0.6)), Quat::Identity()});
  Story sideways = story;
  sideways.given("the cube moved off the slab's corner, so that clipping leaves nothing");
  require_vertex_on_face(sideways, a.body, aside.body, AxisFeature::FaceA);
  require_vertex_on_face(sideways, a.body, aside.body, AxisFeature::FaceB);
  require_clipped_points(story, a.body);

  Story beyond = story;
  beyond.when("the margin is 2 cm").likely("a separation above the margin gives an empty manifold");
  beyond.expect_equal("points", build_manifold(a.body, b.body, axis, Real(0.02)).points.size(), 0);

  Story undefined = story;
  undefined.given("a default-constructed axis, which has no feature")
      .when("the margin is 1 m")
      .likely("an axis without a feature gives an empty manifold, whatever its separation");
  undefined.expect_equal("points", build_manifold(a.body, b.body, {}, 1).points.size(), 0);
}

}  // namespace
}  // namespace cs550::test
