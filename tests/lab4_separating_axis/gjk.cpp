#include "lab4_separating_axis/gjk.hpp"

#include <ccd/ccd.h>

namespace cs550::test {
namespace {

void farthest_vertex(const void* body, const ccd_vec3_t* direction, ccd_vec3_t* result) {
  const Vec3d d(direction->v[0], direction->v[1], direction->v[2]);
  const auto& vertices = static_cast<const ExactBody*>(body)->vertices;
  const Vec3d* farthest = vertices.data();
  for (const Vec3d& v : vertices) {
    if (v.dot(d) > farthest->dot(d)) farthest = &v;
  }
  for (int i = 0; i < 3; ++i) result->v[i] = static_cast<ccd_real_t>((*farthest)[i]);
}

}  // namespace

bool gjk_overlap(const ExactBody& a, const ExactBody& b) {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = farthest_vertex;
  settings.support2 = farthest_vertex;
  settings.max_iterations = 200;
  return ccdGJKIntersect(&a, &b, &settings) != 0;
}

}  // namespace cs550::test
