#include "lab5_clipping/contacts.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "lab5_clipping/pictures.hpp"

namespace cs550::test {

std::string name_of(const FeatureId& id) {
  const char* kinds[] = {"none",          "VertexOnFaceA", "CrossingOnA",   "CornerOfFaceA",
                         "VertexOnFaceB", "CrossingOnB",   "CornerOfFaceB", "Edges"};
  const auto kind = static_cast<std::size_t>(id.kind());
  return std::string(kind < std::size(kinds) ? kinds[kind] : "unknown kind") + " " +
         std::to_string(id.of_a()) + "/" + std::to_string(id.of_b());
}

ShapePtr scaled_shape(const std::string& fixture, Real scale) {
  HalfEdgeMesh mesh = fixture_mesh(fixture);
  for (Vec3& vertex : mesh.vertices) vertex *= scale;
  for (Face& face : mesh.faces) face.plane.offset *= scale;
  const ShapeResult result = make_shape(mesh);
  if (!result) throw std::runtime_error("fixture " + fixture + ": " + result.error);
  return result.shape;
}

Quat turned(Real degrees, const Vec3& axis) {
  return rotation_exp(degrees * pi / 180 * axis.normalized());
}

Pose composed(const Pose& outer, const Pose& inner) {
  return {outer.to_world(inner.position), outer.orientation * inner.orientation};
}

Index face_towards(const HalfEdgeMesh& mesh, const Vec3& direction) {
  Index best = 0;
  for (Index f = 1; f < mesh.face_count(); ++f) {
    if (mesh.face(f).plane.normal.dot(direction) > mesh.face(best).plane.normal.dot(direction))
      best = f;
  }
  return best;
}

Index vertex_at(const HalfEdgeMesh& mesh, const Vec3& place) {
  Index best = 0;
  for (Index v = 1; v < mesh.vertex_count(); ++v) {
    if ((mesh.vertex(v) - place).norm() < (mesh.vertex(best) - place).norm()) best = v;
  }
  return best;
}

std::vector<Index> faces_at(const HalfEdgeMesh& mesh, Index vertex) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (const Index e : face_edges(mesh, f)) {
      if (mesh.edge(e).vertex == vertex) faces.push_back(f);
    }
  }
  return faces;
}

Index edge_between(const HalfEdgeMesh& mesh, Index from, Index to) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.origin(e) == from && mesh.edge(e).vertex == to) return e;
  }
  return no_index;
}

namespace {

FaceQuery query_by_brute_force(const PosedShape& owner, const PosedShape& other, Index face) {
  const Point normal =
      in_world(owner, owner.mesh().face(face).plane.normal) - in_world(owner, Vec3::Zero());
  const Point on_face =
      in_world(owner, owner.mesh().vertex(owner.mesh().edge(owner.mesh().face(face).edge).vertex));
  FaceQuery query{face, no_index, HUGE_VALF};
  for (Index v = 0; v < other.mesh().vertex_count(); ++v) {
    const double distance = normal.dot(in_world(other, other.mesh().vertex(v)) - on_face);
    if (distance < static_cast<double>(query.separation)) {
      query.vertex = v;
      query.separation = static_cast<Real>(distance);
    }
  }
  return query;
}

/// Two side planes at a corner of angle θ intersect 1/sin(θ/2) times as far outside as each of them
/// is offset. This is the largest of these factors.
double corner_stretch(const HalfEdgeMesh& mesh) {
  double largest = 1;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Point in = mesh.edge_vector(e).cast<double>().normalized();
    const Point out = mesh.edge_vector(mesh.edge(e).next).cast<double>().normalized();
    largest = std::max(largest, 2 / (in + out).norm());
  }
  return largest;
}

std::string show(const std::vector<Point>& points) {
  std::ostringstream text;
  text << points.size() << " points";
  for (const Point& p : points) {
    text << (&p == points.data() ? ": (" : ", (") << p.x() << ", " << p.y() << ", " << p.z() << ')';
  }
  return text.str();
}

}  // namespace

SeparatingAxis face_axis(const PosedShape& a, const PosedShape& b, AxisFeature feature,
                         Index face) {
  SeparatingAxis axis;
  axis.feature = feature;
  if (feature == AxisFeature::FaceA) {
    axis.face_a = query_by_brute_force(a, b, face);
    axis.axis = a.plane(face).normal;
    axis.separation = axis.face_a.separation;
  } else {
    axis.face_b = query_by_brute_force(b, a, face);
    axis.axis = -b.plane(face).normal;
    axis.separation = axis.face_b.separation;
  }
  return axis;
}

SeparatingAxis edge_axis(const PosedShape& a, const PosedShape& b, Index edge_a, Index edge_b) {
  const Point from_a = in_world(a, a.mesh().vertex(a.mesh().origin(edge_a)));
  const Point from_b = in_world(b, b.mesh().vertex(b.mesh().origin(edge_b)));
  const Point along_a = in_world(a, a.mesh().vertex(a.mesh().edge(edge_a).vertex)) - from_a;
  const Point along_b = in_world(b, b.mesh().vertex(b.mesh().edge(edge_b).vertex)) - from_b;
  Point n = along_a.cross(along_b).normalized();
  if (n.dot((b.pose.position - a.pose.position).cast<double>()) < 0) n = -n;

  SeparatingAxis axis;
  axis.feature = AxisFeature::Edges;
  axis.edges = {edge_a, edge_b, n.cast<Real>(), static_cast<Real>(n.dot(from_b - from_a))};
  axis.axis = axis.edges.axis;
  axis.separation = axis.edges.separation;
  return axis;
}

Point in_world(const PosedShape& body, const Vec3& point) {
  return body.pose.orientation.cast<double>().normalized() * point.cast<double>() +
         body.pose.position.cast<double>();
}

Point on_a(const PosedShape& a, const ContactPoint& point) { return in_world(a, point.anchor_a); }
Point on_b(const PosedShape& b, const ContactPoint& point) { return in_world(b, point.anchor_b); }
Point middle(const PosedShape& a, const PosedShape& b, const ContactPoint& point) {
  return 0.5 * (on_a(a, point) + on_b(b, point));
}

double outside(const PosedShape& body, const Point& point) {
  const Point local = body.pose.orientation.cast<double>().normalized().conjugate() *
                      (point - body.pose.position.cast<double>());
  double largest = -HUGE_VAL;
  for (const Face& face : body.mesh().faces) {
    largest = std::max(largest, face.plane.normal.cast<double>().dot(local) -
                                    static_cast<double>(face.plane.offset));
  }
  return largest;
}

double separation_along(const PosedShape& a, const PosedShape& b, const Vec3& n) {
  const Point axis = n.cast<double>();
  double top_of_a = -HUGE_VAL;
  double bottom_of_b = HUGE_VAL;
  for (const Vec3& v : a.mesh().vertices) top_of_a = std::max(top_of_a, axis.dot(in_world(a, v)));
  for (const Vec3& v : b.mesh().vertices) {
    bottom_of_b = std::min(bottom_of_b, axis.dot(in_world(b, v)));
  }
  return bottom_of_b - top_of_a;
}

Real deepest_separation(const Manifold& manifold) {
  Real deepest = HUGE_VALF;
  for (const ContactPoint& point : manifold.points) deepest = std::min(deepest, point.separation);
  return deepest;
}

double area_of(const std::vector<Point>& points, const Point& normal) {
  if (points.size() < 3) return 0;
  Point center = Point::Zero();
  for (const Point& p : points) center += p / static_cast<double>(points.size());
  const Point u = normal.unitOrthogonal();
  const Point v = normal.cross(u);
  std::vector<Point> ring = points;
  const auto angle = [&](const Point& p) {
    return std::atan2(v.dot(p - center), u.dot(p - center));
  };
  std::sort(ring.begin(), ring.end(),
            [&](const Point& p, const Point& q) { return angle(p) < angle(q); });
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& next = ring[(i + 1) % ring.size()];
    doubled += normal.dot((ring[i] - center).cross(next - center));
  }
  return doubled / 2;
}

bool expect_points(Story story, const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                   const std::vector<Vec3>& expected, Real tolerance, SourceLine at) {
  std::vector<Point> got;
  for (const ContactPoint& point : manifold.points) got.push_back(middle(a, b, point));
  std::vector<Point> wanted;
  wanted.reserve(expected.size());
  for (const Vec3& point : expected) wanted.push_back(point.cast<double>());

  std::vector<bool> taken(got.size(), false);
  bool all_found = got.size() == wanted.size();
  for (const Point& place : wanted) {
    std::size_t i = 0;
    while (i < got.size() && (taken[i] || (got[i] - place).norm() > static_cast<double>(tolerance)))
      ++i;
    if (i < got.size()) {
      taken[i] = true;
    } else {
      all_found = false;
    }
  }
  if (all_found) return true;
  story.given("each position may be off by at most " + Story::show(tolerance, "m"));
  story.picture([&] { return contact_picture(a, b, expected, manifold); });
  return story.expect_equal("contact points, half-way between the anchors (m)", show(got),
                            show(wanted), at);
}

bool expect_tangent_along(Story& story, const Manifold& manifold, const std::string& edge_name,
                          const Vec3& edge, SourceLine at) {
  const Point along = edge.cast<double>().normalized();
  return story.expect_near("sine of the angle between the tangent and " + edge_name,
                           manifold.tangent.cast<double>().cross(along).norm(), 0, 1e-5, "", at);
}

void require_sound(Story story, const PosedShape& a, const PosedShape& b, const Manifold& manifold,
                   Real size, SourceLine at) {
  // A dozen roundings of float, and the distance of the side planes' corners.
  const double rounding = 3e-6 * static_cast<double>(size);
  const Real smaller = std::min(a.shape->radius, b.shape->radius);
  const double tolerance = static_cast<double>(side_plane_tolerance * smaller) *
                               std::max(corner_stretch(a.mesh()), corner_stretch(b.mesh())) +
                           rounding;
  const Point n = manifold.normal.cast<double>();
  require(story.expect_near("length of the normal", n.norm(), 1, 1e-5, "", at));
  require(story.expect_near("length of the tangent", static_cast<double>(manifold.tangent.norm()),
                            1, 1e-5, "", at));
  require(
      story.expect_near("tangent·normal", n.dot(manifold.tangent.cast<double>()), 0, 1e-5, "", at));
  for (const ContactPoint& point : manifold.points) {
    const Point p_a = on_a(a, point);
    const Point p_b = on_b(b, point);
    require(story.expect_near("separation, against n·(point on B − point on A)",
                              static_cast<double>(point.separation), n.dot(p_b - p_a), rounding,
                              "m", at));
    require(story.expect_at_most("distance of anchor_a outside A", outside(a, p_a), tolerance, "m",
                                 at));
    require(story.expect_at_most("distance of anchor_b outside B", outside(b, p_b), tolerance, "m",
                                 at));
  }
}

}  // namespace cs550::test
