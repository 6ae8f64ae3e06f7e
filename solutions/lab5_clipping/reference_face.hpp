#pragma once
/// @file reference_face.hpp
/// The face that a manifold lies on. Not in namespace cs550: what a lab defines there is what
/// students have to write.

#include "cs550/clipping.hpp"

namespace lab5 {

cs550::Real smaller_radius(const cs550::PosedShape& a, const cs550::PosedShape& b);

/// Where one body is, seen from another: maps points of `body` into the frame of `observer`.
cs550::Pose relative_pose(const cs550::Pose& body, const cs550::Pose& observer);

/// A reference face, and the body that is clipped against it. Points are in the reference body's
/// frame: its planes need no transformation, and only the distance between the bodies matters, not
/// how far they are from the world's origin.
struct ReferenceFace {
  const cs550::PosedShape& body;
  const cs550::PosedShape& incident;
  cs550::Index face;
  bool on_a;
  cs550::Pose incident_frame;  ///< the incident body, seen from the reference body

  /// @param axis its feature, FaceA or FaceB, says whose face it is
  ReferenceFace(const cs550::PosedShape& a, const cs550::PosedShape& b,
                const cs550::SeparatingAxis& axis);

  const cs550::Plane& plane() const { return body.mesh().face(face).plane; }

  /// @param kind_on_a as it is called when A owns the reference face
  cs550::FeatureId feature(cs550::FeatureId::Kind kind_on_a, cs550::Index of_reference,
                           cs550::Index of_incident) const;

  /// The contact of a point on the incident body and its projection onto the plane.
  cs550::ContactPoint contact(const cs550::Vec3& point, cs550::FeatureId id) const;

  /// A manifold along this face that has no points yet.
  cs550::Manifold empty_manifold() const;
};

}  // namespace lab5
