#pragma once
/// @file mesh_validation.hpp
/// Checks the invariants of a half-edge mesh.

#include <optional>
#include <string>

#include "cs550/half_edge_mesh.hpp"

namespace cs550 {

/// The kind of element that violates an invariant.
enum class MeshElement : std::uint8_t { Mesh, Vertex, HalfEdge, Face };

/// A violated invariant.
struct MeshDefect {
  MeshElement element = MeshElement::Mesh;  ///< the kind of element
  Index index = no_index;                   ///< of the element; no_index for the mesh as a whole
  std::string sentence;  ///< "half-edge 12: its twin 13 does not point back to it"
};

/// Returns the first violated invariant of a mesh, if any. The invariants are checked in this
/// order: array sizes and index ranges, finite vertices, twins (`e ^ 1`, opposite, between two
/// places), loops (next/prev, at least three edges, one face), vertex_edge, one fan of at least
/// three faces around each vertex, Euler's V − E + F = 2, unit normals, planar faces, positive
/// signed volume (winding), convexity.
/// @param tolerance for planarity and convexity, relative to the largest extent of the bounds
std::optional<MeshDefect> validate(const HalfEdgeMesh& mesh, Real tolerance = Real(1e-4));

}  // namespace cs550
