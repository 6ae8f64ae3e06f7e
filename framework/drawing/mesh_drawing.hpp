#pragma once
/// @file mesh_drawing.hpp
/// **Lab 2:** Bodies and half-edge meshes. All functions accept invalid indices.

#include "cs550/convex_shape.hpp"
#include "drawing/drawing.hpp"

namespace cs550::drawing {

/// The style of a mesh.
struct MeshStyle {
  Role role = Role::BodyA;      ///< of faces and edges
  Real opacity = Real(0.8);     ///< of the faces; 0 draws none
  Real edge_width = Real(1.6);  ///< pixels; 0 draws none
  bool dashed = false;          ///< edges
  bool vertex_numbers = false;  ///< a label at each vertex
  bool face_numbers = false;    ///< a label in the middle of each face
  bool edge_numbers = false;    ///< a label beside each half-edge, and the half-edge as an arrow
  bool normals = false;         ///< an arrow from the middle of each face
};

/// The faces and edges of a mesh, in its own frame.
Drawing draw_mesh(const HalfEdgeMesh& mesh, const MeshStyle& style = {});

/// The same for a body, in the world frame.
Drawing draw_body(const PosedShape& body, const MeshStyle& style = {});

/// One face as a polygon, in the mesh's frame. A loop that does not close is cut off after as many
/// steps as there are half-edges. @param lift offset outward as a share of the mesh's size, so that
/// the polygon is visible on top of the face
Polygon face_polygon(const HalfEdgeMesh& mesh, Index face, Role role, Real opacity = 1,
                     Real lift = 0);

/// A half-edge as an arrow inside its face, beside the edge.
/// @param inset how far it is moved towards the middle of its face, 0–1
Line half_edge_arrow(const HalfEdgeMesh& mesh, Index edge, const Stroke& stroke,
                     Real inset = Real(0.12));

/// A half-edge with its next, prev, twin and face, each labelled: one step of a walk. Elements that
/// do not exist are left out, with a note.
Drawing draw_half_edge(const HalfEdgeMesh& mesh, Index edge);

/// The mesh with the elements of an issue highlighted and its message below.
/// @param faces, edges, vertices elements of the issue; indices that do not exist are ignored
Drawing draw_mesh_fault(const HalfEdgeMesh& mesh, const std::string& sentence,
                        std::span<const Index> faces, std::span<const Index> edges,
                        std::span<const Index> vertices);

/// Triangles before they are connected, with the elements of an issue highlighted.
Drawing draw_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                       const MeshIssue& issue = {}, const MeshStyle& style = {});

}  // namespace cs550::drawing
