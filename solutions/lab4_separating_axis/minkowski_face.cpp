/// @file minkowski_face.cpp
/// L4.1, document §3.4: whether an edge of A and one of B make a face of the Minkowski difference.

#include "cs550/separating_axis.hpp"

namespace cs550 {

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

}  // namespace cs550
