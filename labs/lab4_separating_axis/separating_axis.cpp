/// @file separating_axis.cpp
/// Lab 4: whether two convex polyhedra overlap, and along which axis. The handout is README.md in
/// this folder. The contract of each function is in framework/include/cs550/separating_axis.hpp.

#include "cs550/separating_axis.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: the separation of two spheres. One axis is enough, from centre to centre. The
/// result is signed, like every separation: positive if they are apart, negative if they overlap.
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
  // L4.1: Each arc spans a plane through the centre of the sphere. On which sides of that plane are
  // the ends of the other arc?
  throw NotImplemented("L4.1");
}

FaceQuery query_face_directions([[maybe_unused]] const PosedShape& a,
                                [[maybe_unused]] const PosedShape& b) {
  // L4.2: Which vertex of B is deepest behind a face of A? Mind the frames.
  throw NotImplemented("L4.2");
}

EdgeQuery query_edge_directions([[maybe_unused]] const PosedShape& a,
                                [[maybe_unused]] const PosedShape& b) {
  // L4.3: Visit each pair of edges once. A cross product has two possible signs: which one points
  // out of A?
  throw NotImplemented("L4.3");
}

SeparatingAxis find_separating_axis([[maybe_unused]] const PosedShape& a,
                                    [[maybe_unused]] const PosedShape& b,
                                    [[maybe_unused]] const SeparatingAxis& hint,
                                    [[maybe_unused]] Real margin) {
  // L4.4: The axis points from A to B, also for a face of B. When may the search stop early?
  throw NotImplemented("L4.4");
}

bool overlap([[maybe_unused]] const PosedShape& a, [[maybe_unused]] const PosedShape& b) {
  // L4.5: Which margin makes L4.4 stop as early as it may?
  throw NotImplemented("L4.5");
}

}  // namespace cs550
