#include "cs550/hill_climbing.hpp"
namespace cs550 {
Support support_brute_force(std::span<const Vec3>, const Vec3&) { return {}; }
Support hill_climb(const HalfEdgeMesh&, const Vec3&, Index, std::vector<Index>* path) {
  if (path != nullptr) path->resize(10'000'000);
  return {};
}
SupportPoint support(const PosedShape&, const Vec3&, Index) { return {}; }
}  // namespace cs550
