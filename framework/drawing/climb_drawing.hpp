#pragma once
/// @file climb_drawing.hpp
/// **Lab 3:** The walk to the most extreme vertex.

#include "cs550/half_edge_mesh.hpp"
#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"

namespace cs550::drawing {

/// Draws a mesh, the direction as an arrow, and the walk as arrows from vertex to vertex with the
/// dot product at each. Small dots mark the visited neighbours. No vertex should be beyond the
/// plane through the end of the walk. Vertices that do not exist are left out, with a note.
/// @param direction in the mesh's frame, any length
/// @param path vertices of the walk, from the start to the answer
/// @param role of the walk: Highlight, or Expected beside Got
Drawing draw_climb(const HalfEdgeMesh& mesh, const Vec3& direction, std::span<const Index> path,
                   Role role = Role::Highlight);

/// Plots the dot product at each step of the walk, with the maximum over all vertices as a mark.
Plot plot_climb(const HalfEdgeMesh& mesh, const Vec3& direction, std::span<const Index> path);

}  // namespace cs550::drawing
