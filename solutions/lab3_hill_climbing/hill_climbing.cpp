/// @file hill_climbing.cpp
/// Lab 3, reference. Document §3.1, with dot(vertex, direction) in place of "the distance from the
/// origin": the farthest vertex need not be the most extreme one in a direction.

#include "cs550/hill_climbing.hpp"

namespace cs550 {

Support support_brute_force(std::span<const Vec3> vertices, const Vec3& direction) {
  Support best{0, static_cast<int>(vertices.size())};
  Real height = vertices[0].dot(direction);
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    const Real candidate = vertices[v].dot(direction);
    if (candidate > height) {
      height = candidate;
      best.vertex = static_cast<Index>(v);
    }
  }
  return best;
}

Support hill_climb(const HalfEdgeMesh& mesh, const Vec3& direction, Index start,
                   std::vector<Index>* path) {
  Support best{start, 1};
  Real height = mesh.vertex(start).dot(direction);
  if (path) path->assign(1, start);

  Index here;
  do {
    here = best.vertex;
    for (const Index e : vertex_edges(mesh, here)) {
      const Index neighbour = mesh.edge(e).vertex;
      const Real candidate = mesh.vertex(neighbour).dot(direction);
      ++best.visited;
      if (candidate > height) {
        height = candidate;
        best.vertex = neighbour;
      }
    }
    if (path && best.vertex != here) path->push_back(best.vertex);
  } while (best.vertex != here);
  return best;
}

SupportPoint support(const PosedShape& body, const Vec3& direction, Index start) {
  const Vec3 local_direction = body.pose.unrotate(direction);
  const Index vertex = hill_climb(body.mesh(), local_direction, start).vertex;
  return {vertex, body.vertex(vertex)};
}

}  // namespace cs550
