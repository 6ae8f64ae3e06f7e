/// @file clipping.cpp
/// Lab 5: from a separating axis to contact points. The handout is README.md in this folder. The
/// contract of each function is in framework/include/cs550/clipping.hpp, the types that it fills in
/// contact.hpp in the same folder.

#include "cs550/clipping.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: cuts a straight rope at a plane and keeps the part where the distance is ≤ 0. A
/// polygon is a closed chain of such ropes, with corners that also carry names.
[[maybe_unused]] StaticVector<Vec3, 2> cut_rope(const Vec3& from, const Vec3& to,
                                                const Plane& plane) {
  StaticVector<Vec3, 2> kept;
  const Real d_from = plane.distance(from);
  const Real d_to = plane.distance(to);

  if (d_from <= 0) kept.push_back(from);
  // The distance varies linearly along the rope. It is zero at the fraction
  // d_from / (d_from − d_to). An end on the plane is kept and needs no intersection.
  const bool crosses = (d_from < 0 && d_to > 0) || (d_from > 0 && d_to < 0);
  if (crosses) kept.push_back(from + d_from / (d_from - d_to) * (to - from));
  if (d_to <= 0) kept.push_back(to);
  return kept;
}

}  // namespace

ClipPolygon clip_polygon([[maybe_unused]] const ClipPolygon& polygon,
                         [[maybe_unused]] const Plane& plane,
                         [[maybe_unused]] ClipEdge plane_edge) {
  // L5.1: Walk around the polygon once. Each edge emits corners by the table in the handout.
  throw NotImplemented("L5.1");
}

Index find_incident_face([[maybe_unused]] const PosedShape& body, [[maybe_unused]] Index vertex,
                         [[maybe_unused]] const Vec3& reference_normal) {
  // L5.2: Only the faces around the vertex count. Transform the one normal, not all of theirs.
  throw NotImplemented("L5.2");
}

Manifold face_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                       [[maybe_unused]] const SeparatingAxis& axis, [[maybe_unused]] Real margin) {
  // L5.3: Work in the frame of the reference body. Which body is that, and how does a point of the
  // other body get there?
  throw NotImplemented("L5.3");
}

Manifold edge_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                       [[maybe_unused]] const SeparatingAxis& axis) {
  // L5.4: Clamping the closest point on one edge moves the closest point on the other.
  throw NotImplemented("L5.4");
}

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    [[maybe_unused]] std::span<const ContactPoint> points, [[maybe_unused]] const Vec3& normal,
    [[maybe_unused]] Real margin) {
  // L5.5: Which four points make a body hardest to tip?
  throw NotImplemented("L5.5");
}

Manifold build_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                        [[maybe_unused]] const SeparatingAxis& axis, [[maybe_unused]] Real margin) {
  // L5.6: Which separations are comparable, and which of the queries may be empty?
  throw NotImplemented("L5.6");
}

}  // namespace cs550
