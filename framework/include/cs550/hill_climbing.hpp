#pragma once
/// @file hill_climbing.hpp
/// **Lab 3:** The vertex that is most extreme in a direction, found by walking.
/// Document §3.1; Gregorius, *The Separating Axis Test between Convex Polyhedra* (GDC 2013).

#include <span>
#include <vector>

#include "cs550/convex_shape.hpp"

namespace cs550 {

/// The vertex that maximises dot(vertex, direction), and what it cost to find.
struct Support {
  Index vertex = no_index;  ///< the most extreme one
  int visited = 0;          ///< dot products computed, the start's included
};

/// **L3.1** Looks at every vertex: O(V). The first of several equal ones wins.
/// @param vertices any frame, at least one
/// @param direction same frame, any length
Support support_brute_force(std::span<const Vec3> vertices, const Vec3& direction);

/// **L3.2** Walks uphill: from the start to the best of its neighbours, as long as that is strictly
/// better. On a convex mesh a vertex without a better neighbour is the most extreme one; on a
/// plateau no neighbour is *strictly* better, so the walk ends. About √V dot products on a
/// well-shaped mesh.
/// @param mesh   body frame
/// @param direction body frame, any length
/// @param start  where to begin: any vertex; the answer for a similar direction saves the walk
/// @param path   if given, receives the vertices stood on, from the start to the answer
Support hill_climb(const HalfEdgeMesh& mesh, const Vec3& direction, Index start,
                   std::vector<Index>* path = nullptr);

/// A vertex and where it is.
struct SupportPoint {
  Index vertex = no_index;  ///< of the body's mesh
  Vec3 point = {0, 0, 0};   ///< world frame (m)
};

/// **L3.3** The most extreme point of a body in a world direction. The direction is turned into the
/// body frame, Rᵀ·d, and not translated; the point comes back to the world.
/// @param direction world frame, any length
/// @param start where to begin
SupportPoint support(const PosedShape& body, const Vec3& direction, Index start = 0);

}  // namespace cs550
