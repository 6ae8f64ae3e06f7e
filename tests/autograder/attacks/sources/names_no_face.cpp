#include "cs550/separating_axis.hpp"
namespace cs550 {
constexpr Index wild = 1 << 28;
bool is_minkowski_face(const Vec3&, const Vec3&, const Vec3&, const Vec3&) { return false; }
FaceQuery query_face_directions(const PosedShape&, const PosedShape&) { return {wild, -wild, 0}; }
EdgeQuery query_edge_directions(const PosedShape&, const PosedShape&) {
  return {wild, -wild, {1, 0, 0}, 0};
}
SeparatingAxis find_separating_axis(const PosedShape& a, const PosedShape& b, const SeparatingAxis&,
                                    Real) {
  const FaceQuery face = query_face_directions(a, b);
  return {AxisFeature::FaceA, {1, 0, 0}, -1, face, face, query_edge_directions(a, b)};
}
bool overlap(const PosedShape&, const PosedShape&) { return true; }
}  // namespace cs550
