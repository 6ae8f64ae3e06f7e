#pragma once
/// @file reference_face.hpp
/// The face that a manifold lies on. In a namespace of the lab's own: what a lab defines in cs550 itself is
/// what students have to write.

#include "cs550/clipping.hpp"

namespace cs550::lab5 {

Real smaller_radius(const PosedShape& a, const PosedShape& b);

/// Where one body is, seen from another: maps points of `body` into the frame of `observer`.
Pose relative_pose(const Pose& body, const Pose& observer);

/// A reference face, and the body that is clipped against it. Points are in the reference body's
/// frame: its planes need no transformation, and only the distance between the bodies matters, not
/// how far they are from the world's origin.
struct ReferenceFace {
  const PosedShape& body;
  const PosedShape& incident;
  Index face;
  Index deepest_vertex;  ///< of the incident body, behind the face
  bool on_a;
  Pose incident_frame;  ///< the incident body, seen from the reference body

  /// @param axis its feature, FaceA or FaceB, says whose face it is
  ReferenceFace(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis);

  const Plane& plane() const { return body.mesh().face(face).plane; }
  Index incident_face() const {
    return find_incident_face(incident, deepest_vertex, body.pose.rotate(plane().normal));
  }

  /// @param kind_on_a as it is called when A owns the reference face
  FeatureId feature(FeatureId::Kind kind_on_a, Index of_reference, Index of_incident) const;

  /// Names a corner of the clipped incident face by the two edges that meet in it.
  FeatureId corner_feature(const ClipVertex& corner, Index incident_face) const;

  /// The contact of a point on the incident body and its projection onto the plane.
  ContactPoint contact(const Vec3& point, FeatureId id) const;

  /// A manifold along this face that has no points yet.
  Manifold empty_manifold() const;
};

}  // namespace cs550::lab5
