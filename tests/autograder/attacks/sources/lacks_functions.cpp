#include "cs550/hill_climbing.hpp"
namespace cs550 {
SupportPoint support(const PosedShape& body, const Vec3& direction, Index start) {
  const Index vertex = hill_climb(body.mesh(), body.pose.unrotate(direction), start).vertex;
  return SupportPoint{vertex, body.vertex(vertex)};
}
}  // namespace cs550
