#pragma once
/// @file climb_drawing.hpp
/// **Lab 3:** The walk to the most extreme vertex.

#include "cs550/half_edge_mesh.hpp"
#include "drawing/drawing.hpp"
#include "drawing/plot.hpp"

namespace cs550::drawing {

/// The arrow that shows the direction of a climb. It is outside of the mesh, on a ray from the
/// middle of its bounds.
struct ClimbArrow {
  Vec3 middle = Vec3::Zero();  ///< of the mesh (m)
  Vec3 tail = Vec3::Zero();    ///< m
  Vec3 tip = Vec3::UnitZ();    ///< m
};

/// The arrow that draw_climb() draws. A direction without a length is drawn upward.
ClimbArrow climb_arrow(const HalfEdgeMesh& mesh, const Vec3& direction);

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
