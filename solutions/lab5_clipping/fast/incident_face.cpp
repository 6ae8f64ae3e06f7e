/// @file incident_face.cpp
/// Lab 5 for the engine: L5.2 for four faces at a time.

#include "cs550/clipping.hpp"
#include "engine/wide_mesh.hpp"

namespace cs550 {

Index find_incident_face(const PosedShape& body, const Vec3& reference_normal) {
  const FourVectors normal = four_times(body.pose.unrotate(reference_normal));
  const HalfEdgeMesh& mesh = body.mesh();
  Four smallest = four_times(HUGE_VALF);  // of each lane's faces, and the first four that hold it
  FourMask first_of_four = {};
  for (Index face = 0; face < mesh.face_count(); face += 4) {
    const Four cosine = normal.dot(four_planes(mesh, face).normal);
    const FourMask is_smaller = cosine < smallest;
    smallest = is_smaller ? cosine : smallest;
    first_of_four = is_smaller ? face - FourMask{} : first_of_four;
  }
  const Real smallest_of_all = smallest_lane(smallest);
  Index best = no_index;
  for (Index lane = 0; lane < 4; ++lane) {
    if (smallest[lane] != smallest_of_all) continue;
    const Index face = first_of_four[lane] + lane;
    if (best == no_index || face < best) best = face;
  }
  return best;
}

}  // namespace cs550
