#pragma once
/// @file recorded_meshes.hpp
/// Generates the fixtures with the reference solution of lab 2.

#include <string>
#include <vector>

#include "cs550/half_edge_mesh.hpp"

namespace cs550::test {

struct RecordedMesh {
  std::string name;
  HalfEdgeMesh mesh;
};

/// Generates all fixtures. Numbers in a name are extents in metres or counts. Coplanar faces are
/// merged unless noted.
///
/// - `cube` (1 m), `box_1x2x3`, `box_0.4x1x2` (the one that tumbles), `slab`, `needle`
/// - `corner_tetrahedron` (its origin in the corner), `regular_tetrahedron`, `sliver` (a tetrahedron
///   that is nearly flat: two edges cross 2 cm apart)
/// - `prism3`, `prism6`, `prism32`, `pyramid4`, `dodecahedron`
/// - `icosphere0`–`icosphere3`: 12, 42, 162, 642 vertices, radius 1 m
/// - `hull8`–`hull256`: hulls of that many random points on the unit sphere
/// - `bunny_hull`, `teapot_hull`: largest extent 1 m
/// - `triangulated_cube`: 12 triangles, not merged
/// - `twin_peaks`: **not convex**. Along +z vertex 6 (z = 1 m) is higher than its neighbours, vertex
///   7 (z = 2 m) is the highest
std::vector<RecordedMesh> record_meshes();

}  // namespace cs550::test
