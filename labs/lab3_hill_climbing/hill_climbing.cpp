/// @file hill_climbing.cpp
/// Lab 3: the vertex that is most extreme in a direction. The handout is README.md, beside this file;
/// what each function promises stands in framework/include/cs550/hill_climbing.hpp.

#include "cs550/hill_climbing.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: how many vertices share an edge with this one. It shows how to visit all
/// neighbours of a vertex: each half-edge that leaves the vertex *points to* one of them.
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
  // L3.1, step 1: begin with the first vertex as the best one, and its measure along the direction.
  // L3.1, step 2: measure every other vertex; only a strictly better one takes over.
  // L3.1, step 3: return the best one and how many measurements you made.
  // See README.md, L3.1.
  throw NotImplemented("L3.1");
}

Support hill_climb([[maybe_unused]] const HalfEdgeMesh& mesh,
                   [[maybe_unused]] const Vec3& direction, [[maybe_unused]] Index start,
                   [[maybe_unused]] std::vector<Index>* path) {
  // L3.2, step 1: stand on the start and measure it: that is the first visit.
  //               If there is a path, it begins (and only begins) with the start.
  // L3.2, step 2: measure every neighbour of the vertex you stand on, counting each as a visit, and
  //               remember the best of those that are better than where you stand.
  // L3.2, step 3: if there was one, step onto it (and tell the path), then do step 2 again.
  // L3.2, step 4: if there was none, you are at the top.
  // See README.md, L3.2.
  throw NotImplemented("L3.2");
}

SupportPoint support([[maybe_unused]] const PosedShape& body,
                     [[maybe_unused]] const Vec3& direction, [[maybe_unused]] Index start) {
  // L3.3, step 1: the mesh is in the body frame and the direction in the world: bring the direction
  //               to the mesh, not the mesh to the direction.
  // L3.3, step 2: climb.
  // L3.3, step 3: return the vertex and where it is in the world.
  // See README.md, L3.3.
  throw NotImplemented("L3.3");
}

}  // namespace cs550
