#include "lab4_separating_axis/gjk.hpp"

#include <ccd/ccd.h>

#include <algorithm>

namespace cs550::test {
namespace {

/// A body in units in which the larger of two bodies has size 1: libccd compares with absolute tolerances, and
/// they are too wide for bodies of 1 cm.
struct Enlarged {
  const ExactBody& body;
  double factor;
};

void farthest_vertex(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* result) {
  const Vec3d d(direction->v[0], direction->v[1], direction->v[2]);
  const Enlarged& enlarged = *static_cast<const Enlarged*>(object);
  const auto& vertices = enlarged.body.vertices;
  const Vec3d* farthest = vertices.data();
  for (const Vec3d& v : vertices) {
    if (v.dot(d) > farthest->dot(d)) farthest = &v;
  }
  const Vec3d vertex = enlarged.factor * *farthest;
  for (int i = 0; i < 3; ++i) result->v[i] = static_cast<ccd_real_t>(vertex[i]);
}

}  // namespace

bool gjk_overlap(const ExactBody& a, const ExactBody& b) {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = farthest_vertex;
  settings.support2 = farthest_vertex;
  settings.max_iterations = 200;
  const double factor = 1 / std::max(a.size, b.size);
  const Enlarged enlarged_a{a, factor};
  const Enlarged enlarged_b{b, factor};
  return ccdGJKIntersect(&enlarged_a, &enlarged_b, &settings) != 0;
}

}  // namespace cs550::test
