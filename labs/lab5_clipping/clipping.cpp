/// @file clipping.cpp
/// Lab 5: from an axis to contact points. The handout is README.md, beside this file; what each
/// function promises stands in framework/include/cs550/clipping.hpp and contact.hpp.

#include "cs550/clipping.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: the part of a straight rope that is on the near side of a plane (distance ≤ 0).
/// A polygon is a closed chain of such ropes; its corners also carry names, which a rope does not.
[[maybe_unused]] StaticVector<Vec3, 2> cut_rope(const Vec3& from, const Vec3& to,
                                                const Plane& plane) {
  StaticVector<Vec3, 2> kept;
  const Real d_from = plane.distance(from);
  const Real d_to = plane.distance(to);

  if (d_from <= 0) kept.push_back(from);
  // The distance grows evenly along the rope: it is zero where d_from / (d_from − d_to) of the way
  // is done. An end that lies on the plane is kept as it is, so it needs no intersection.
  const bool crosses = (d_from < 0 && d_to > 0) || (d_from > 0 && d_to < 0);
  if (crosses) kept.push_back(from + d_from / (d_from - d_to) * (to - from));
  if (d_to <= 0) kept.push_back(to);
  return kept;
}

}  // namespace

ClipPolygon clip_polygon([[maybe_unused]] const ClipPolygon& polygon,
                         [[maybe_unused]] const Plane& plane,
                         [[maybe_unused]] ClipEdge plane_edge) {
  // L5.1, step 1: go round the polygon once; the corner after the last one is the first.
  // L5.1, step 2: for each pair of neighbours, look the two sides up in the handout's table and
  //               emit what it says. Which side is "front" here? And a corner on the plane?
  // L5.1, step 3: a new corner lies on one of the polygon's edges and on the plane: give it both
  //               names, in the order in which they are walked.
  // L5.1, step 4: where the outline passes through the plane exactly in a corner, that corner ends
  //               (or begins) the new edge: change one of its two names.
  // See README.md, L5.1.
  throw NotImplemented("L5.1");
}

Index find_incident_face([[maybe_unused]] const PosedShape& body,
                         [[maybe_unused]] const Vec3& reference_normal) {
  // L5.2, step 1: bring the normal to the body, not the body's normals to the world.
  // L5.2, step 2: find the face whose normal points against it the most. How do you measure that?
  // See README.md, L5.2.
  throw NotImplemented("L5.2");
}

Manifold face_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                       [[maybe_unused]] const SeparatingAxis& axis, [[maybe_unused]] Real margin) {
  // L5.3, step 1: say which body owns the reference face and which one is incident. Work in the
  //               frame of the first: how does a point of the other get there?
  // L5.3, step 2: write the incident face as a polygon. Its edges are its half-edges.
  // L5.3, step 3: clip it by one plane for each edge of the reference face. Which way do these
  //               planes face? Which body's frame are they in?
  // L5.3, step 4: measure what is left against the reference plane and drop what is too far.
  // L5.3, step 5: make each remaining corner a ContactPoint. Which anchor is the corner itself,
  //               which its projection? Mind that the normal points A → B whoever owns the face.
  // L5.3, step 6: name each point: the two edges of its corner say which features meet.
  // L5.3, step 7: choose a tangent and reduce the points.
  // See README.md, L5.3.
  throw NotImplemented("L5.3");
}

Manifold edge_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                       [[maybe_unused]] const SeparatingAxis& axis) {
  // L5.4, step 1: bring both edges into one frame.
  // L5.4, step 2: find the closest points of the two lines, then of the two segments: a clamped
  //               point on one edge moves the closest point of the other.
  // L5.4, step 3: fill in one ContactPoint and the rest of the manifold.
  // See README.md, L5.4.
  throw NotImplemented("L5.4");
}

StaticVector<ContactPoint, max_manifold_points> reduce_manifold(
    [[maybe_unused]] std::span<const ContactPoint> points, [[maybe_unused]] const Vec3& normal) {
  // L5.5, step 1: what if there are not too many?
  // L5.5, step 2: one point must not be lost, whatever the others look like.
  // L5.5, step 3: which point makes the longest lever with it?
  // L5.5, step 4: these two make a line. On either side of it a third spans a triangle with them:
  //               which one the largest? What if all points lie on one line?
  // L5.5, step 5: a point outside the triangle sees one of its edges from outside. Which point adds
  //               the most area, whichever the edge?
  // See README.md, L5.5.
  throw NotImplemented("L5.5");
}

Manifold build_manifold([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b,
                        [[maybe_unused]] const SeparatingAxis& axis, [[maybe_unused]] Real margin) {
  // L5.6, step 1: nothing to do for bodies that are too far apart.
  // L5.6, step 2: which of the two face queries do you clip against? What if they are equal?
  // L5.6, step 3: when do the edges take over? Compare like with like, and on which side of the
  //               comparison does the preference for faces stand?
  // L5.6, step 4: clipping may throw away what made the bodies overlap. How can you tell, and what
  //               is left to fall back on?
  // See README.md, L5.6.
  throw NotImplemented("L5.6");
}

}  // namespace cs550
