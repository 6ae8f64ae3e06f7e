#pragma once
/// @file support_search.hpp
/// Lab 3 for the engine: the same support vertex, or one equally far, without path and count.

#include <algorithm>
#include <array>

#include "cs550/half_edge_mesh.hpp"
#include "engine/wide_mesh.hpp"

namespace cs550 {

/// The next half-edge that leaves the same vertex, clockwise. Twins are adjacent in the array, so
/// this takes a single load.
inline Index next_around_vertex(const HalfEdgeMesh& mesh, Index e) { return mesh.edge(e ^ 1).next; }

/// So many vertices are searched four at a time.
inline constexpr Index few_vertices = 48;

/// The first vertex with the smallest dot(vertex, direction), of all vertices. @pre they are few
inline Index lowest_of_all(const HalfEdgeMesh& mesh, const Vec3& direction) {
  const FourVectors wide_direction = four_times(direction);
  std::array<Four, few_vertices / 4> heights;
  Four lowest = four_times(HUGE_VALF);
  std::size_t four = 0;
  for_all_fours(mesh.vertex_count(), [&](Index v) {
    heights[four] = four_vertices(mesh, v).dot(wide_direction);
    lowest = smaller(heights[four++], lowest);
  });
  lowest = four_times(smallest_lane(lowest));

  Index first = no_index;
  four = 0;
  for_all_fours(mesh.vertex_count(), [&](Index v) {
    const FourMask equal = heights[four++] == lowest;
    if (first == no_index && any(equal)) first = v + first_lane(equal);
  });
  return std::max(first, Index(0));  // none if the direction is not a number
}

/// The vertex with the smallest dot(vertex, direction); `start` if there is no smaller one. A box is
/// searched vertex by vertex. Meshes with few vertices are searched four at a time, without a branch
/// that depends on them. Larger ones are climbed.
inline Index lowest_vertex(const HalfEdgeMesh& mesh, const Vec3& direction, Index start) {
  constexpr Index very_few = 12;
  Index lowest = start;
  Real height = mesh.vertex(start).dot(direction);
  const auto offer = [&](Index v) {
    const Real candidate = mesh.vertex(v).dot(direction);
    lowest = candidate < height ? v : lowest;
    height = candidate < height ? candidate : height;
  };
  if (mesh.vertex_count() <= very_few) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) offer(v);
    return lowest;
  }
  if (mesh.vertex_count() <= few_vertices) {
    offer(lowest_of_all(mesh, direction));
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
