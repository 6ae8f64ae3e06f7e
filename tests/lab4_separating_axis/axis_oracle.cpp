#include "lab4_separating_axis/axis_oracle.hpp"

#include <algorithm>

#include "drawing/gauss_map_drawing.hpp"
#include "helpers/fixtures.hpp"
#include "helpers/picture.hpp"
#include "lab4_separating_axis/gauss_map.hpp"

namespace cs550::test {

ShapePtr scaled_shape(const std::string& name, Real factor) {
  HalfEdgeMesh mesh = fixture_mesh(name);
  for (Vec3& vertex : mesh.vertices) vertex *= factor;
  for (Face& face : mesh.faces) face.plane.offset *= factor;
  return make_shape(mesh).shape;
}

std::vector<ShapePtr> small_shapes(Real factor) {
  std::vector<ShapePtr> shapes;
  for (const char* name : {"cube", "box_1x2x3", "regular_tetrahedron", "corner_tetrahedron",
                           "prism3", "prism6", "pyramid4", "hull8", "hull16"}) {
    shapes.push_back(scaled_shape(name, factor));
  }
  return shapes;
}

TestPair random_pair(Random& random, const std::vector<ShapePtr>& shapes, const Vec3& place) {
  const int last = static_cast<int>(shapes.size()) - 1;
  const ShapePtr& shape_a = shapes[random.integer(0, last)];
  const ShapePtr& shape_b = shapes[random.integer(0, last)];
  const Real reach = shape_a->radius + shape_b->radius;
  const Vec3 way = random.real(Real(0.35), Real(0.95)) * reach * random.unit_vector();
  const Quat turn_a = random.orientation();
  const Quat turn_b = random.orientation();
  return {{shape_a.get(), {place, turn_a}}, {shape_b.get(), {place + way, turn_b}}, "random"};
}

ExactEdges exact_edges(const TestPair& pair) {
  struct Edge {
    Vec3d point, along, left, right;
  };
  const auto edges_of = [&](const PosedShape& body) {
    const HalfEdgeMesh& mesh = body.mesh();
    const ExactBody exact(body, pair.a.pose.position);
    std::vector<Edge> edges;
    for (Index e = 0; e < mesh.edge_count(); e += 2) {
      const auto normal = [&](Index half) { return exact.normals[mesh.edge(half).face]; };
      edges.push_back(
          {exact.vertices[mesh.origin(e)], exact.edges[e / 2], normal(e), normal(e + 1)});
    }
    return edges;
  };
  ExactEdges best;
  const std::vector<Edge> edges_b = edges_of(pair.b);
  for (const Edge& a : edges_of(pair.a)) {
    for (const Edge& b : edges_b) {
      const Crossing crossing = crossing_by_lengths(a.left, a.right, -b.left, -b.right);
      const Vec3d cross = a.along.cross(b.along);
      if (crossing == Crossing::No || cross.norm() < 1e-6) continue;
      const double outward = cross.dot(a.left + a.right) > 0 ? 1 : -1;
      const double separation = (outward * cross.normalized()).dot(b.point - a.point);
      best.any = std::max(best.any, separation);
      const bool clear = crossing == Crossing::Yes && cross.norm() > 2 * double{parallel_sine};
      if (clear) best.clear = std::max(best.clear, separation);
    }
  }
  return best;
}

Story about(Story story, const TestPair& pair) {
  const auto describe = [&](const std::string& name, const PosedShape& body) {
    const Quat& q = body.pose.orientation;
    story.given(name + " has " + std::to_string(body.mesh().vertex_count()) + " vertices, radius",
                body.shape->radius, "m");
    story.given("x_" + name, body.pose.position, "m").given("q_" + name, q);
  };
  story.given("pair: " + pair.names);
  describe("A", pair.a);
  describe("B", pair.b);
  return story;
}

namespace {

/// Checks that the feature, its query, the axis and the separation are consistent.
void require_query_behind_it(Story& here, const TestPair& pair, const SeparatingAxis& answer,
                             double tolerance) {
  Real of_query = 0;
  Vec3 axis = Vec3::Zero();
  switch (answer.feature) {
    case AxisFeature::None:
      require(here.expect("feature of the answer", false, "None", "FaceA, FaceB or Edges"));
      break;
    case AxisFeature::FaceA:
      require(
          here.expect_index("face of A in face_a", answer.face_a.face, pair.a.mesh().face_count()));
      of_query = answer.face_a.separation;
      axis = pair.a.plane(answer.face_a.face).normal;
      break;
    case AxisFeature::FaceB:
      require(
          here.expect_index("face of B in face_b", answer.face_b.face, pair.b.mesh().face_count()));
      of_query = answer.face_b.separation;
      axis = -pair.b.plane(answer.face_b.face).normal;
      break;
    case AxisFeature::Edges:
      require(here.expect_index("half-edge of A in edges", answer.edges.edge_a,
                                pair.a.mesh().edge_count()));
      require(here.expect_index("half-edge of B in edges", answer.edges.edge_b,
                                pair.b.mesh().edge_count()));
      of_query = answer.edges.separation;
      axis = answer.edges.axis;
      break;
  }
  require(here.expect_near("axis against that of its feature", answer.axis, axis, 1e-5));
  require(here.expect_near("separation against that of its query", answer.separation, of_query,
                           tolerance, "m"));
}

}  // namespace

std::string axis_picture(const TestPair& pair, const SeparatingAxis& got) {
  const BestSeparations best = best_separations(pair.exact_a(), pair.exact_b());
  SeparatingAxis wanted;
  wanted.axis = best.axis.cast<Real>();
  wanted.separation = static_cast<Real>(best.largest());
  drawing::Drawing expected = drawing::draw_axis(pair.a, pair.b, wanted, drawing::Role::Expected);
  expected.title = "Expected: the best axis of all";
  drawing::Drawing found = drawing::draw_axis(pair.a, pair.b, got, drawing::Role::Got);
  found.title = "Got: " + drawing::feature_text(got);
  // Seen perpendicular to both axes, which are then parallel to the page.
  drawing::View view;
  const Vec3 across = wanted.axis.cross(got.axis);
  view.toward_eye = across.norm() > Real(1e-3) ? across : any_perpendicular(wanted.axis);
  view.up = wanted.axis;
  view.frame = bounds(expected);
  drawing::View sphere_view;
  sphere_view.toward_eye = wanted.axis + view.toward_eye.normalized();
  drawing::Drawing sphere = drawing::draw_gauss_maps(pair.a, pair.b, {}, got);
  add_arrow(sphere, wanted.axis, Real(0.45) * wanted.axis,
            {drawing::Role::Expected, 4, false, true}, "expected");
  return side_by_side("The axis that separates most, the expected one upward",
                      {drawing::Scene{expected, view}, drawing::Scene{found, view},
                       drawing::Scene{sphere, sphere_view}});
}

void require_best_axis(const Story& story, const TestPair& pair, const SeparatingAxis& answer,
                       Real margin, double tolerance) {
  Story here = about(story, pair);
  here.picture([&] { return axis_picture(pair, answer); });
  const double allowed = tolerance * double{pair.larger_radius()};
  const double tie = 1.01 * double{tie_tolerance} * double{pair.smaller_radius()};

  require_query_behind_it(here, pair, answer, allowed);
  require(here.expect_near("length of the axis", double{answer.axis.norm()}, 1, 1e-5));

  const ExactBody a = pair.exact_a();
  const ExactBody b = pair.exact_b();
  const double along = separation_along(a, b, answer.axis.cast<double>().normalized());
  // The axis is rounded too. A cross product of edges at a small angle has an error of more than
  // one unit in the last place.
  require(here.expect_near("separation along the axis, A to B", answer.separation, along, allowed,
                           "m"));
  if (answer.separation > margin) return;

  const BestSeparations best = best_separations(a, b);
  here.given("largest separation over faces of A", best.face_a, "m")
      .given("over faces of B", best.face_b, "m")
      .given("over cross products of edges", best.edges, "m");
  if (best.largest() <= 0) {
    require(here.expect_near("separation against brute force", answer.separation, best.largest(),
                             allowed + tie, "m"));
  }
  // If separated bodies are closest at corners, some cross product may separate more than any
  // Minkowski face. Faces, and edges whose arcs cross, are a lower bound.
  const double over_arcs = exact_edges(pair).clear;
  here.given("over edges whose arcs cross", over_arcs, "m");
  require(here.expect_at_least("separation against the faces", answer.separation,
                               best.faces() - allowed - tie, "m"));
  require(here.expect_at_least("separation against edges whose arcs cross", answer.separation,
                               over_arcs - allowed - tie, "m"));
  require(here.expect_at_most("separation against brute force", answer.separation,
                              best.largest() + allowed, "m"));
  // A kind that does not separate may win a tie, but not if the margin is 0.
  if (best.largest() >= allowed) {
    const double bound = margin > 0 ? -allowed - tie : 0;
    require(here.expect("separation of bodies that are apart", answer.separation > bound,
                        Story::show(answer.separation, "m"),
                        "more than " + Story::show(bound, "m")));
  }
}

}  // namespace cs550::test
