/// @file clipping.cpp
/// Lab 5, reference, L5.1 to L5.3: a face clipped against a face. Document §3.6–3.7; Sutherland &
/// Hodgman (1974); Gregorius, *Robust Contact Creation for Physics Simulations* (GDC 2015).

#include "cs550/clipping.hpp"

#include <algorithm>

#include "reference_face.hpp"

namespace cs550 {

using lab5::ReferenceFace;
using lab5::smaller_radius;

namespace {

/// A face as a polygon, its corners named by the half-edges of its loop.
ClipPolygon face_polygon(const HalfEdgeMesh& mesh, Index face, const Pose& pose) {
  ClipPolygon polygon;
  for (const Index e : face_edges(mesh, face)) {
    const HalfEdge& half = mesh.edge(e);
    polygon.push_back({pose.to_world(mesh.vertex(half.vertex)),
                       {ClipEdge::Source::Incident, e},
                       {ClipEdge::Source::Incident, half.next}});
  }
  return polygon;
}

/// The plane through an edge of a face, perpendicular to the face, facing out of it.
Plane side_plane(const HalfEdgeMesh& mesh, Index edge, const Vec3& face_normal, Real outward) {
  const Vec3 normal = mesh.edge_vector(edge).cross(face_normal).normalized();
  return {normal, normal.dot(mesh.vertex(mesh.origin(edge))) + outward};
}

bool is_inside(const ClipPolygon& polygon, const Plane& plane) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [&](const ClipVertex& corner) { return plane.distance(corner.point) <= 0; });
}

}  // namespace

ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane& plane, ClipEdge plane_edge) {
  ClipPolygon clipped;
  if (polygon.empty()) return clipped;

  Real before = plane.distance(polygon.back().point);
  Real here = plane.distance(polygon[0].point);
  for (int i = 0; i < polygon.size(); ++i) {
    const ClipVertex& a = polygon[i];
    const ClipVertex& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const Real after = plane.distance(b.point);

    if (here <= 0) {
      clipped.push_back(a);
      // The outline passes through the plane in this corner: no intersection is emitted, the corner
      // takes its place.
      if (here == 0 && before > 0 && after < 0) clipped.back().in = plane_edge;
      if (here == 0 && before < 0 && after > 0) clipped.back().out = plane_edge;
    }
    const bool leaves = here < 0 && after > 0;
    const bool enters = here > 0 && after < 0;
    if (leaves || enters) {
      const Vec3 intersection = a.point + (here / (here - after)) * (b.point - a.point);
      clipped.push_back({intersection, leaves ? a.out : plane_edge, leaves ? plane_edge : a.out});
    }
    before = here;
    here = after;
  }
  return clipped;
}

Index find_incident_face(const PosedShape& body, Index vertex, const Vec3& reference_normal) {
  const Vec3 normal = body.pose.unrotate(reference_normal);
  const HalfEdgeMesh& mesh = body.mesh();
  const auto cosine = [&](Index face) { return normal.dot(mesh.face(face).plane.normal); };
  const auto precedes = [&](Index a, Index b) {
    return cosine(a) < cosine(b) || (cosine(a) == cosine(b) && a < b);
  };
  Index incident = mesh.edge(mesh.vertex_edge[static_cast<std::size_t>(vertex)]).face;
  for (const Index e : vertex_edges(mesh, vertex)) {
    const Index face = mesh.edge(e).face;
    if (precedes(face, incident)) incident = face;
  }
  return incident;
}

Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin) {
  const ReferenceFace reference(a, b, axis);
  const HalfEdgeMesh& mesh = reference.body.mesh();
  const Plane& plane = reference.plane();

  const Index incident_face = reference.incident_face();
  ClipPolygon polygon =
      face_polygon(reference.incident.mesh(), incident_face, reference.incident_frame);
  const Real tolerance = side_plane_tolerance * smaller_radius(a, b);
  for (const Index e : face_edges(mesh, reference.face)) {
    const Plane side = side_plane(mesh, e, plane.normal, tolerance);
    if (!is_inside(polygon, side)) {
      polygon = clip_polygon(polygon, side, {ClipEdge::Source::Reference, e});
    }
  }

  StaticVector<ContactPoint, ClipPolygon::capacity()> points;
  for (const ClipVertex& corner : polygon) {
    if (plane.distance(corner.point) > margin) continue;
    points.push_back(
        reference.contact(corner.point, reference.corner_feature(corner, incident_face)));
  }
  Manifold manifold = reference.empty_manifold();
  manifold.points = reduce_manifold({points.data(), static_cast<std::size_t>(points.size())},
                                    a.pose.unrotate(manifold.normal), margin);
  return manifold;
}

}  // namespace cs550
