#pragma once
/// Lab 5 whose functions do nothing but attack.

#include "cs550/clipping.hpp"

namespace attack {

using Points = cs550::StaticVector<cs550::ContactPoint, cs550::max_manifold_points>;

Points points();

inline cs550::Manifold manifold() {
  cs550::Manifold manifold;
  manifold.normal = {1, 0, 0};
  manifold.tangent = {0, 1, 0};
  manifold.reference = static_cast<cs550::AxisFeature>(200);
  manifold.points = points();
  return manifold;
}

}  // namespace attack

namespace cs550 {

ClipPolygon clip_polygon(const ClipPolygon& polygon, const Plane&, ClipEdge) { return polygon; }

Index find_incident_face(const PosedShape&, Index, const Vec3&) { return 1 << 28; }

Manifold face_manifold(const PosedShape&, const PosedShape&, const SeparatingAxis&, Real) {
  return attack::manifold();
}

Manifold edge_manifold(const PosedShape&, const PosedShape&, const SeparatingAxis&) {
  return attack::manifold();
}

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(std::span<const ContactPoint>,
                                                                const Vec3&, Real) {
  return attack::points();
}

Manifold build_manifold(const PosedShape&, const PosedShape&, const SeparatingAxis&, Real) {
  return attack::manifold();
}

}  // namespace cs550
