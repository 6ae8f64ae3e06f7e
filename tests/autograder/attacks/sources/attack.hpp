#pragma once
/// Lab 3 for attacks that try something and know whether it worked: right answers if it did, wrong ones
/// if not. Points mean that the attack worked.

#include "cs550/hill_climbing.hpp"

namespace attack {

bool succeeds();

inline cs550::Index best(std::span<const cs550::Vec3> vertices, const cs550::Vec3& direction) {
  static const bool worked = succeeds();
  cs550::Index best = 0;
  for (std::size_t i = 1; worked && i < vertices.size(); ++i) {
    const auto v = static_cast<cs550::Index>(i);
    if (vertices[i].dot(direction) > vertices[static_cast<std::size_t>(best)].dot(direction))
      best = v;
  }
  return worked ? best : -1;
}

}  // namespace attack

namespace cs550 {

Support support_brute_force(std::span<const Vec3> vertices, const Vec3& direction) {
  return {attack::best(vertices, direction), static_cast<int>(vertices.size())};
}

Support hill_climb(const HalfEdgeMesh& mesh, const Vec3& direction, Index, std::vector<Index>*) {
  return {attack::best(mesh.vertices, direction), 1};
}

SupportPoint support(const PosedShape& body, const Vec3& direction, Index) {
  const Vec3 inside = body.pose.unrotate(direction);
  const Index vertex = attack::best(body.mesh().vertices, inside);
  return {vertex, vertex < 0 ? Vec3(0, 0, 0) : body.vertex(vertex)};
}

}  // namespace cs550
