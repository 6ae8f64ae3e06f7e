#pragma once
/// @file mesh_io.hpp
/// Reads and writes mesh files.

#include <filesystem>

#include "cs550/primitives.hpp"

namespace cs550 {

/// Reads a Wavefront OBJ file with tinyobjloader and splits polygons into triangles. Repairs
/// nothing: faults of the triangles are reported by build_half_edge_mesh(). Errors name the file and
/// the line: a coordinate that is not a finite number, a vertex number that no vertex has.
SoupResult load_obj(const std::filesystem::path& file);

/// Writes a half-edge mesh as JSON (vertices, half-edges, faces), the format of test fixtures.
std::string to_json(const HalfEdgeMesh& mesh);

/// A mesh, or an error message.
struct MeshResult {
  HalfEdgeMesh mesh;  ///< empty on error
  std::string error;  ///< empty on success
};

/// Reads a mesh written by to_json(), without checking it. Errors name the file and the JSON path of what is no
/// number or no index.
MeshResult read_mesh_json(const std::filesystem::path& file);

/// Reads a mesh written by to_json() and checks it with validate(). Errors name the file.
/// @param tolerance passed to validate(); HUGE_VALF accepts a mesh that is not convex
MeshResult load_mesh_json(const std::filesystem::path& file, Real tolerance = Real(1e-4));

}  // namespace cs550
