#pragma once
/// @file support_search.hpp
/// Lab 3 for the engine: the same support vertex, or one equally far, without path and count.

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// The next half-edge that leaves the same vertex, clockwise. Twins are adjacent in the array, so
/// this takes a single load.
inline Index next_around_vertex(const HalfEdgeMesh& mesh, Index e) { return mesh.edge(e ^ 1).next; }

/// The vertex with the smallest dot(vertex, direction). Small meshes are searched vertex by vertex,
/// which the processor predicts well. Larger ones are climbed from `start`.
inline Index lowest_vertex(const HalfEdgeMesh& mesh, const Vec3& direction, Index start) {
  constexpr Index few = 24;
  Index lowest = start;
  Real height = mesh.vertex(start).dot(direction);
  const auto offer = [&](Index v) {
    const Real candidate = mesh.vertex(v).dot(direction);
    lowest = candidate < height ? v : lowest;
    height = candidate < height ? candidate : height;
  };
  if (mesh.vertex_count() <= few) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) offer(v);
    return lowest;
  }
  Index here;
  do {
    here = lowest;
    const Index first = mesh.vertex_edge[here];
    Index e = first;
    do {
      offer(mesh.edge(e).vertex);
      e = next_around_vertex(mesh, e);
    } while (e != first);
  } while (lowest != here);
  return lowest;
}

}  // namespace cs550
