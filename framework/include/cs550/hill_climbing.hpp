#pragma once
/// @file hill_climbing.hpp
/// **Lab 3:** Support functions: the vertex of a convex body that is most extreme in a direction,
/// found by hill climbing. Document §3.1; Gregorius, *The Separating Axis Test between Convex
/// Polyhedra* (GDC 2013).

#include <span>
#include <vector>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// The vertex that maximises dot(vertex, direction), and the cost of finding it.
struct Support {
  Index vertex = no_index;  ///< the most extreme vertex
  int visited = 0;          ///< dot products computed, including the start's
};

/// **L3.1** Compares all vertices, in O(V). On a tie the vertex with the smallest index wins.
/// @param vertices any frame, at least one
/// @param direction same frame, any length
Support support_brute_force(std::span<const Vec3> vertices, const Vec3& direction);

/// **L3.2** Steepest ascent: moves to the best neighbour for as long as that is strictly better
/// than the current vertex. On a convex mesh the result is the most extreme vertex, or one of
/// several on a plateau. On a well-shaped mesh this takes about 3·√V dot products.
/// @param mesh body frame
/// @param direction body frame, any length
/// @param start any vertex; a good start is the result for a similar direction
/// @param path if not null, replaced by the vertices along the climb, from the start to the result
Support hill_climb(const HalfEdgeMesh& mesh, const Vec3& direction, Index start,
                   std::vector<Index>* path = nullptr);

/// A vertex and its position.
struct SupportPoint {
  Index vertex = no_index;  ///< of the body's mesh
  Vec3 point = {0, 0, 0};   ///< world frame (m)
};

/// **L3.3** The most extreme point of a body in a world direction. Uses hill_climb().
/// @param direction world frame, any length
/// @param start the vertex at which the climb starts
SupportPoint support(const PosedShape& body, const Vec3& direction, Index start = 0);

}  // namespace cs550
