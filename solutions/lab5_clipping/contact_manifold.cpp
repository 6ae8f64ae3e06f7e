/// @file contact_manifold.cpp
/// Lab 5, reference, L5.4 and L5.6: edges against edges, and which manifold an axis asks for.
/// Ericson, *Real-Time Collision Detection*, §5.1.9.

#include <algorithm>
#include <cmath>

#include "cs550/clipping.hpp"
#include "reference_face.hpp"

namespace cs550 {

using lab5::ReferenceFace;
using lab5::relative_pose;
using lab5::smaller_radius;

namespace {

using Kind = FeatureId::Kind;

/// An edge as the points start + s·along, 0 ≤ s ≤ 1.
struct Segment {
  Vec3 start;
  Vec3 along;

  Vec3 at(Real s) const { return start + s * along; }
  /// The parameter of the point of the segment that is closest to another point.
  Real closest(const Vec3& point) const {
    return std::clamp((point - start).dot(along) / along.squaredNorm(), Real(0), Real(1));
  }
};

/// The parameter on a of the point that is closest to the *line* of b, clamped to the segment.
Real closest_to_line(const Segment& a, const Segment& b) {
  const Vec3 cross = a.along.cross(b.along);
  const Real squared = cross.squaredNorm();
  if (squared == 0) return 0;  // parallel: any point will do
  return std::clamp((b.start - a.start).cross(b.along).dot(cross) / squared, Real(0), Real(1));
}

Real deepest_separation(const Manifold& manifold) {
  Real deepest = HUGE_VALF;
  for (const ContactPoint& point : manifold.points) deepest = std::min(deepest, point.separation);
  return deepest;
}

/// The kind of the better face query; the axis's own kind where they are equal.
AxisFeature better_face(const SeparatingAxis& axis, Real tolerance) {
  const Real a = axis.face_a ? axis.face_a.separation : -HUGE_VALF;
  const Real b = axis.face_b ? axis.face_b.separation : -HUGE_VALF;
  if (axis.feature == AxisFeature::FaceB) {
    return b >= a - tolerance ? AxisFeature::FaceB : AxisFeature::FaceA;
  }
  return a >= b - tolerance ? AxisFeature::FaceA : AxisFeature::FaceB;
}

/// One point: the vertex that the face query found deepest.
Manifold vertex_manifold(const ReferenceFace& reference) {
  const Index vertex = reference.deepest_vertex;
  const Vec3 point = reference.incident_frame.to_world(reference.incident.mesh().vertex(vertex));
  Manifold manifold = reference.empty_manifold();
  manifold.points.push_back(
      reference.contact(point, reference.feature(Kind::VertexOnFaceA, reference.face, vertex)));
  return manifold;
}

}  // namespace

Manifold edge_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis) {
  const EdgeQuery& edges = axis.edges;
  const Pose b_in_a = relative_pose(b.pose, a.pose);
  const Segment edge_a{a.mesh().vertex(a.mesh().origin(edges.edge_a)),
                       a.mesh().edge_vector(edges.edge_a)};
  const Segment edge_b{b_in_a.to_world(b.mesh().vertex(b.mesh().origin(edges.edge_b))),
                       b_in_a.rotate(b.mesh().edge_vector(edges.edge_b))};

  // Clamping one parameter moves the best value of the other (Ericson §5.1.9).
  const Real t = edge_b.closest(edge_a.at(closest_to_line(edge_a, edge_b)));
  const Real s = edge_a.closest(edge_b.at(t));

  const Vec3 normal = a.pose.unrotate(edges.axis);
  ContactPoint point;
  point.anchor_a = edge_a.at(s);
  point.anchor_b = b_in_a.to_body(edge_b.at(t));
  point.separation = normal.dot(edge_b.at(t) - edge_a.at(s));
  point.feature = {Kind::Edges, edges.edge_a / 2, edges.edge_b / 2};

  Manifold manifold;
  manifold.normal = edges.axis;
  manifold.tangent = a.pose.rotate((edge_a.along - edge_a.along.dot(normal) * normal).normalized());
  manifold.reference = AxisFeature::Edges;
  manifold.points.push_back(point);
  return manifold;
}

Manifold build_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                        Real margin) {
  if (axis.feature == AxisFeature::None || axis.separation > margin) return {};
  if (!axis.face_a && !axis.face_b) return edge_manifold(a, b, axis);

  const Real radius = smaller_radius(a, b);
  SeparatingAxis face_axis = axis;
  face_axis.feature = better_face(axis, tie_tolerance * radius);
  const FaceQuery& face = face_axis.feature == AxisFeature::FaceA ? axis.face_a : axis.face_b;

  const Real preference = edge_preference * radius;
  if (axis.edges && axis.edges.separation > face.separation + preference) {
    return edge_manifold(a, b, axis);
  }

  Manifold manifold = face_manifold(a, b, face_axis, margin);
  const bool lost_the_deepest = deepest_separation(manifold) > face.separation + preference;
  if (!lost_the_deepest) return manifold;
  if (axis.edges && axis.edges.separation >= face.separation) return edge_manifold(a, b, axis);
  if (axis.separation > 0 && !manifold.points.empty()) return manifold;
  return vertex_manifold(ReferenceFace(a, b, face_axis));
}

}  // namespace cs550
