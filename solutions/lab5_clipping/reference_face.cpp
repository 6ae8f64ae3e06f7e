#include "reference_face.hpp"

#include <algorithm>

namespace cs550::lab5 {

namespace {

using Kind = FeatureId::Kind;

/// The same kind of point with the reference face on B: the kinds for B follow those for A.
Kind called_on_b(Kind kind_on_a) {
  constexpr int a_to_b =
      static_cast<int>(Kind::VertexOnFaceB) - static_cast<int>(Kind::VertexOnFaceA);
  return static_cast<Kind>(static_cast<int>(kind_on_a) + a_to_b);
}

}  // namespace

Real smaller_radius(const PosedShape& a, const PosedShape& b) {
  return std::min(a.shape->radius, b.shape->radius);
}

Pose relative_pose(const Pose& body, const Pose& observer) {
  return {observer.to_body(body.position), observer.orientation.conjugate() * body.orientation};
}

ReferenceFace::ReferenceFace(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis)
    : body(axis.feature == AxisFeature::FaceA ? a : b),
      incident(axis.feature == AxisFeature::FaceA ? b : a),
      face(axis.feature == AxisFeature::FaceA ? axis.face_a.face : axis.face_b.face),
      deepest_vertex(axis.feature == AxisFeature::FaceA ? axis.face_a.vertex : axis.face_b.vertex),
      on_a(axis.feature == AxisFeature::FaceA),
      incident_frame(relative_pose(incident.pose, body.pose)) {}

FeatureId ReferenceFace::feature(Kind kind_on_a, Index of_reference, Index of_incident) const {
  if (on_a) return {kind_on_a, of_reference, of_incident};
  return {called_on_b(kind_on_a), of_incident, of_reference};
}

FeatureId ReferenceFace::corner_feature(const ClipVertex& corner, Index incident_face) const {
  const bool in_is_incident = corner.in.source == ClipEdge::Source::Incident;
  const bool out_is_incident = corner.out.source == ClipEdge::Source::Incident;
  if (in_is_incident && out_is_incident) {
    return feature(Kind::VertexOnFaceA, face, incident.mesh().edge(corner.in.edge).vertex);
  }
  if (!in_is_incident && !out_is_incident) {
    // The polygon runs clockwise about the reference face: it comes in along the later side.
    return feature(Kind::CornerOfFaceA, body.mesh().origin(corner.in.edge), incident_face);
  }
  const ClipEdge& side = in_is_incident ? corner.out : corner.in;
  const ClipEdge& clipped = in_is_incident ? corner.in : corner.out;
  return feature(Kind::CrossingOnA, side.edge / 2, clipped.edge / 2);
}

ContactPoint ReferenceFace::contact(const Vec3& point, FeatureId id) const {
  const Real separation = plane().distance(point);
  const Vec3 projection = point - separation * plane().normal;
  ContactPoint contact;
  contact.anchor_a = on_a ? projection : incident_frame.to_body(point);
  contact.anchor_b = on_a ? incident_frame.to_body(point) : projection;
  contact.separation = separation;
  contact.feature = id;
  return contact;
}

Manifold ReferenceFace::empty_manifold() const {
  const Vec3 edge = body.mesh().edge_vector(body.mesh().face(face).edge);
  const Vec3 tangent = (edge - edge.dot(plane().normal) * plane().normal).normalized();
  Manifold manifold;
  manifold.normal = body.pose.rotate(on_a ? plane().normal : Vec3(-plane().normal));
  manifold.tangent = body.pose.rotate(tangent);
  manifold.reference = on_a ? AxisFeature::FaceA : AxisFeature::FaceB;
  return manifold;
}

}  // namespace cs550::lab5
