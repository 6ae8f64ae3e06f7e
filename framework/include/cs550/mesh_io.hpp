#pragma once
/// @file mesh_io.hpp
/// Meshes from and to files.

#include <filesystem>

#include "cs550/primitives.hpp"

namespace cs550 {

/// Reads a Wavefront OBJ file (tinyobjloader), polygons split into triangles. Nothing is repaired:
/// build_half_edge_mesh() says what is wrong with the triangles, if anything. Errors name the file.
SoupResult load_obj(const std::filesystem::path& file);

/// A half-edge mesh as JSON (vertices, half-edges, faces): what fixtures are stored as.
/// Loading checks the result with validate(); errors name the file.
std::string to_json(const HalfEdgeMesh& mesh);

/// A mesh, or a sentence that says why there is none.
struct MeshResult {
  HalfEdgeMesh mesh;  ///< empty if there is an error
  std::string error;  ///< empty if there is a mesh
};

/// @param tolerance of validate(); HUGE_VALF takes a mesh that is not convex
MeshResult load_mesh_json(const std::filesystem::path& file, Real tolerance = Real(1e-4));

}  // namespace cs550
