#include "cs550/hill_climbing.hpp"
namespace cs550 {
Support support_brute_force(std::span<const Vec3>, const Vec3&) { return {1 << 30, 1}; }
Support hill_climb(const HalfEdgeMesh&, const Vec3&, Index, std::vector<Index>* path) {
  if (path != nullptr) *path = {-1, 1 << 30, -(1 << 30)};
  return {-(1 << 30), 1};
}
SupportPoint support(const PosedShape&, const Vec3&, Index) { return {1 << 30, {0, 0, 0}}; }
}  // namespace cs550
