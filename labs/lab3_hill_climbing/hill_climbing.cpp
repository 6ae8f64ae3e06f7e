/// @file hill_climbing.cpp
/// Lab 3: the vertex that is most extreme in a direction. The handout is README.md in this folder.
/// The contract of each function is in framework/include/cs550/hill_climbing.hpp.

#include "cs550/hill_climbing.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: counts the vertices that share an edge with a vertex. It shows how to visit all
/// neighbours: each half-edge that leaves the vertex *points to* one of them.
[[maybe_unused]] int count_neighbours(const HalfEdgeMesh& mesh, Index vertex) {
  int count = 0;
  for (const Index e : vertex_edges(mesh, vertex)) {
    const Index neighbour = mesh.edge(e).vertex;
    if (neighbour != vertex) ++count;
  }
  return count;
}

}  // namespace

Support support_brute_force([[maybe_unused]] std::span<const Vec3> vertices,
                            [[maybe_unused]] const Vec3& direction) {
  // L3.1: Start with a value that cannot be greater than the answer.
  throw NotImplemented("L3.1");
}

Support hill_climb([[maybe_unused]] const HalfEdgeMesh& mesh,
                   [[maybe_unused]] const Vec3& direction, [[maybe_unused]] Index start,
                   [[maybe_unused]] std::vector<Index>* path) {
  // L3.2: When is the climb over? Think of a flat top.
  throw NotImplemented("L3.2");
}

SupportPoint support([[maybe_unused]] const PosedShape& body,
                     [[maybe_unused]] const Vec3& direction, [[maybe_unused]] Index start) {
  // L3.3: The mesh is in the body frame and the direction in the world frame. Which one do you
  // transform?
  throw NotImplemented("L3.3");
}

}  // namespace cs550
