/// @file face_manifold.cpp
/// L5.3 for the engine: the teaching form with vectors in registers, and with its bits.

#include <utility>

#include "../reference_face.hpp"
#include "outline.hpp"

namespace cs550 {

namespace lab5 {
namespace {

PackedPlane side_plane(const HalfEdgeMesh& mesh, Index edge, Packed face_normal, Real outward) {
  const Packed origin = packed(mesh.vertex(mesh.origin(edge)));
  const Packed along = packed(mesh.vertex(mesh.edge(edge).vertex)) - origin;
  const Packed normal = normalized(cross(along, face_normal));
  return {normal, dot(normal, origin) + outward};
}

/// A reference face, and what is clipped against it, in its body's frame.
struct Clipping {
  const ReferenceFace& reference;
  Index incident_face;
  PackedPlane plane;
  PackedPose incident_frame;

  explicit Clipping(const ReferenceFace& reference_face)
      : reference(reference_face),
        incident_face(reference.incident_face()),
        plane{packed(reference.plane().normal), reference.plane().offset},
        incident_frame(reference.incident_frame) {}

  void start(Outline& outline) const {
    const HalfEdgeMesh& mesh = reference.incident.mesh();
    for (const Index e : face_edges(mesh, incident_face)) {
      const HalfEdge& half = mesh.edge(e);
      outline.push_back(incident_frame.to_world(packed(mesh.vertex(half.vertex))),
                        {ClipEdge::Source::Incident, e}, {ClipEdge::Source::Incident, half.next});
    }
  }

  ContactPoint contact(Packed point, Real separation, const ClipVertex& names) const {
    const Vec3 on_incident = unpacked(incident_frame.to_body(point));
    const Vec3 projection = unpacked(point - all(separation) * plane.normal);
    ContactPoint contact;
    contact.anchor_a = reference.on_a ? projection : on_incident;
    contact.anchor_b = reference.on_a ? on_incident : projection;
    contact.separation = separation;
    contact.feature = reference.corner_feature(names, incident_face);
    return contact;
  }
};

}  // namespace
}  // namespace lab5

using lab5::Outline;

Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin) {
  const lab5::ReferenceFace reference(a, b, axis);
  const lab5::Clipping clipping(reference);

  Outline outlines[2];
  Outline* outline = &outlines[0];
  Outline* clipped = &outlines[1];
  clipping.start(*outline);
  const HalfEdgeMesh& mesh = reference.body.mesh();
  const Real tolerance = side_plane_tolerance * lab5::smaller_radius(a, b);
  for (const Index e : face_edges(mesh, reference.face)) {
    if (outline->empty()) break;
    const lab5::PackedPlane side = lab5::side_plane(mesh, e, clipping.plane.normal, tolerance);
    if (clipped->clip(*outline, side, {ClipEdge::Source::Reference, e})) {
      std::swap(outline, clipped);
    }
  }

  StaticVector<ContactPoint, ClipPolygon::capacity()> points;
  for (std::size_t i = 0; i < outline->size(); ++i) {
    const Real separation = clipping.plane.distance(outline->point(i));
    if (separation > margin) continue;
    points.push_back(clipping.contact(outline->point(i), separation, outline->names(i)));
  }
  Manifold manifold = reference.empty_manifold();
  manifold.points = reduce_manifold({points.data(), static_cast<std::size_t>(points.size())},
                                    a.pose.unrotate(manifold.normal), margin);
  return manifold;
}

}  // namespace cs550
