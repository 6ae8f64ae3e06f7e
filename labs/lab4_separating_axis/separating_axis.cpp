/// @file separating_axis.cpp
/// Lab 4: whether two convex polyhedra overlap, and along which axis. The handout is README.md,
/// beside this file; what each function promises stands in
/// framework/include/cs550/separating_axis.hpp.

#include "cs550/separating_axis.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: the separation of two spheres, where one axis is enough: from centre to centre.
/// Signed, like every separation: positive apart, negative by the depth of penetration.
[[maybe_unused]] Real sphere_separation(const Vec3& center_a, Real radius_a, const Vec3& center_b,
                                        Real radius_b) {
  const Vec3 axis = (center_b - center_a).normalized();
  const Vec3 point_on_a = center_a + radius_a * axis;
  const Vec3 point_on_b = center_b - radius_b * axis;
  return axis.dot(point_on_b - point_on_a);
}

}  // namespace

bool is_minkowski_face([[maybe_unused]] const Vec3& a, [[maybe_unused]] const Vec3& b,
                       [[maybe_unused]] const Vec3& c, [[maybe_unused]] const Vec3& d) {
  // L4.1, step 1: the normal of the plane through the centre of the sphere and each arc.
  // L4.1, step 2: on which side of each plane do the ends of the other arc lie?
  // L4.1, step 3: the arcs cross if each plane has the ends of the other arc on both sides, and
  //               both arcs lie in the same hemisphere.
  // See README.md, L4.1.
  throw NotImplemented("L4.1");
}

FaceQuery query_face_directions([[maybe_unused]] const PosedShape& a,
                                [[maybe_unused]] const PosedShape& b) {
  // L4.2, step 1: for each face of A find the vertex of B that is farthest against its normal.
  // L4.2, step 2: measure the signed distance of that vertex from the plane of the face.
  // L4.2, step 3: keep the face with the largest one.
  // See README.md, L4.2.
  throw NotImplemented("L4.2");
}

EdgeQuery query_edge_directions([[maybe_unused]] const PosedShape& a,
                                [[maybe_unused]] const PosedShape& b) {
  // L4.3, step 1: visit each pair of edges once (every second half-edge), and bring both edges and
  //               the normals beside them into one frame.
  // L4.3, step 2: skip the pair if its arcs do not cross. What must happen to B's normals?
  // L4.3, step 3: the axis is perpendicular to both edges. Skip the pair if they are parallel: by
  //               the sine of their angle, whatever their lengths.
  // L4.3, step 4: turn the axis so that it points out of A, make it unit length, and measure the
  //               signed separation along it.
  // L4.3, step 5: keep the pair with the largest separation; its axis is wanted in the world.
  // See README.md, L4.3.
  throw NotImplemented("L4.3");
}

SeparatingAxis find_separating_axis([[maybe_unused]] const PosedShape& a,
                                    [[maybe_unused]] const PosedShape& b,
                                    [[maybe_unused]] const SeparatingAxis& hint,
                                    [[maybe_unused]] Real margin) {
  // L4.4, step 1: the faces of A, the faces of B, the edges. Which way does the axis of a face of B
  //               point?
  // L4.4, step 2: stop as soon as one of them is separated by more than the margin.
  // L4.4, step 3: otherwise the largest separation wins; on a tie the kind of feature that the hint
  //               has, then a face of A, then a face of B, then edges.
  // L4.4, step 4: before all that, try the features of the hint alone: they may still separate.
  // See README.md, L4.4.
  throw NotImplemented("L4.4");
}

bool overlap([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b) {
  // L4.5, step 1: ask L4.4, with no hint. Which margin makes it stop as early as it may?
  // See README.md, L4.5.
  throw NotImplemented("L4.5");
}

}  // namespace cs550
