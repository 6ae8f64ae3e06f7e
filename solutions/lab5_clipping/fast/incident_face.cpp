/// @file incident_face.cpp
/// Lab 5 for the engine: L5.2 for four faces at a time. No branch depends on a face until the smallest cosine is known.

#include "cs550/clipping.hpp"
#include "engine/wide_mesh.hpp"

namespace cs550 {

Index find_incident_face(const PosedShape& body, const Vec3& reference_normal) {
  const FourVectors normal = four_times(body.pose.unrotate(reference_normal));
  const auto cosines = [&](const PlaneBlock& block) {
    return normal.dot(four_planes(block).normal);
  };
  const std::vector<PlaneBlock>& blocks = body.shape->plane_blocks;
  Four smallest = four_times(HUGE_VALF);
  for (const PlaneBlock& block : blocks) smallest = smaller(cosines(block), smallest);
  smallest = four_times(smallest_lane(smallest));

  Index face = 0;
  for (const PlaneBlock& block : blocks) {
    const FourMask is_smallest = cosines(block) == smallest;
    if (any(is_smallest)) return face + first_lane(is_smallest);
    face += 4;
  }
  return 0;  // the normal is not a number
}

}  // namespace cs550
