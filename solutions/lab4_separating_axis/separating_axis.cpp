/// @file separating_axis.cpp
/// Lab 4, reference. Document §3.2–3.5; Gregorius, *The Separating Axis Test between Convex
/// Polyhedra* (GDC 2013).
///
/// Everything is computed in A's body frame with one relative pose, so that only the distance
/// between the bodies matters and not how far they are from the world's origin.

#include "cs550/separating_axis.hpp"

#include <algorithm>

#include "cs550/hill_climbing.hpp"
#include "features.hpp"

namespace cs550 {

using lab4::best_feature;
using lab4::with_feature;

namespace {

/// Two meshes, and where B is in A's body frame.
struct Pair {
  const HalfEdgeMesh& a;
  const HalfEdgeMesh& b;
  Pose b_in_a;

  Pair(const PosedShape& body_a, const PosedShape& body_b)
      : a(body_a.mesh()),
        b(body_b.mesh()),
        b_in_a{body_a.pose.to_body(body_b.pose.position),
               body_a.pose.orientation.conjugate() * body_b.pose.orientation} {}
};

/// One face of A against B's support vertex on the opposite side (document §3.5).
FaceQuery query_face(const Pair& pair, Index face, Index start) {
  const Plane& plane = pair.a.face(face).plane;
  const Vec3 direction = pair.b_in_a.unrotate(-plane.normal);
  const Index vertex = hill_climb(pair.b, direction, start).vertex;
  return {face, vertex, plane.distance(pair.b_in_a.to_world(pair.b.vertex(vertex)))};
}

/// An edge, and the normals of the faces beside it: the ends of its arc on the Gauss map.
struct EdgeArc {
  Index edge;
  Vec3 origin;
  Vec3 along;
  Vec3 left;
  Vec3 right;
};

EdgeArc arc_of(const HalfEdgeMesh& mesh, Index edge) {
  const HalfEdge& half = mesh.edge(edge);
  return {edge, mesh.vertex(mesh.origin(edge)), mesh.edge_vector(edge),
          mesh.face(half.face).plane.normal, mesh.face(mesh.edge(half.twin).face).plane.normal};
}

EdgeArc placed(const EdgeArc& arc, const Pose& pose) {
  return {arc.edge, pose.to_world(arc.origin), pose.rotate(arc.along), pose.rotate(arc.left),
          pose.rotate(arc.right)};
}

/// One edge of A against one of B, both in A's frame: the signed separation
/// n·(p_B − p_A) with n = ±(e_A × e_B)/|e_A × e_B|, or nothing if they give no Minkowski face.
EdgeQuery query_edge_pair(const EdgeArc& a, const EdgeArc& b) {
  if (!is_minkowski_face(a.left, a.right, -b.left, -b.right)) return {};

  const Vec3 cross = a.along.cross(b.along);
  const Real length = cross.norm();
  if (length < parallel_sine * a.along.norm() * b.along.norm()) return {};

  const Real outward = cross.dot(a.left + a.right) > 0 ? Real(1) : Real(-1);
  const Vec3 axis = (outward / length) * cross;
  return {a.edge, b.edge, axis, axis.dot(b.origin - a.origin)};
}

/// Last step's features at today's poses; no axis if there was none or its edges no longer give a
/// Minkowski face.
SeparatingAxis retest(const PosedShape& a, const PosedShape& b, const SeparatingAxis& hint) {
  SeparatingAxis result;
  switch (hint.feature) {
    case AxisFeature::FaceA:
      result.face_a = query_face(Pair(a, b), hint.face_a.face, hint.face_a.vertex);
      break;
    case AxisFeature::FaceB:
      result.face_b = query_face(Pair(b, a), hint.face_b.face, hint.face_b.vertex);
      break;
    case AxisFeature::Edges: {
      const Pair pair(a, b);
      result.edges = query_edge_pair(arc_of(pair.a, hint.edges.edge_a),
                                     placed(arc_of(pair.b, hint.edges.edge_b), pair.b_in_a));
      if (!result.edges) return {};
      result.edges.axis = a.pose.rotate(result.edges.axis);
      break;
    }
    case AxisFeature::None:
      break;
  }
  return with_feature(hint.feature, result, a, b);
}

}  // namespace

bool is_minkowski_face(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 bxa = b.cross(a);
  const Vec3 dxc = d.cross(c);
  const Real cba = c.dot(bxa);
  const Real dba = d.dot(bxa);
  const Real adc = a.dot(dxc);
  const Real bdc = b.dot(dxc);
  // Each arc's ends lie on both sides of the other's plane, and both arcs in the same hemisphere.
  return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

FaceQuery query_face_directions(const PosedShape& a, const PosedShape& b) {
  const Pair pair(a, b);
  FaceQuery best = query_face(pair, 0, 0);
  Index start = best.vertex;
  for (Index face = 1; face < pair.a.face_count(); ++face) {
    const FaceQuery query = query_face(pair, face, start);
    if (query.separation > best.separation) best = query;
    start = query.vertex;
  }
  return best;
}

EdgeQuery query_edge_directions(const PosedShape& a, const PosedShape& b) {
  const Pair pair(a, b);
  EdgeQuery best;
  for (Index e_b = 0; e_b < pair.b.edge_count(); e_b += 2) {
    const EdgeArc arc_b = placed(arc_of(pair.b, e_b), pair.b_in_a);
    for (Index e_a = 0; e_a < pair.a.edge_count(); e_a += 2) {
      const EdgeQuery query = query_edge_pair(arc_of(pair.a, e_a), arc_b);
      if (query && (!best || query.separation > best.separation)) best = query;
    }
  }
  best.axis = a.pose.rotate(best.axis);
  return best;
}

SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b,
                                    const SeparatingAxis& hint, Real margin) {
  SeparatingAxis result = retest(a, b, hint);
  if (result.feature != AxisFeature::None && result.separation > margin) return result;

  result = {};
  result.face_a = query_face_directions(a, b);
  if (result.face_a.separation > margin) return with_feature(AxisFeature::FaceA, result, a, b);

  result.face_b = query_face_directions(b, a);
  if (result.face_b.separation > margin) return with_feature(AxisFeature::FaceB, result, a, b);

  result.edges = query_edge_directions(a, b);
  if (result.edges && result.edges.separation > margin) {
    return with_feature(AxisFeature::Edges, result, a, b);
  }

  const Real tolerance = tie_tolerance * std::min(a.shape->radius, b.shape->radius);
  return with_feature(best_feature(result, hint.feature, tolerance), result, a, b);
}

bool overlap(const PosedShape& a, const PosedShape& b) {
  return find_separating_axis(a, b, {}, 0).separation <= 0;
}

}  // namespace cs550
