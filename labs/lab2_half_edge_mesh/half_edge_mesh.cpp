/// @file half_edge_mesh.cpp
/// Lab 2, L2.1 to L2.5: from triangles to a closed mesh; L2.6 to L2.9 are in merging.cpp. The
/// handout is README.md in this folder. The contract of each function is in
/// framework/include/cs550/half_edge_mesh.hpp.

#include "cs550/half_edge_mesh.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: counts the edges that two faces share. It shows the three moves of this lab:
/// around a face, across an edge to the twin, and from a half-edge to its face.
[[maybe_unused]] int count_shared_edges(const HalfEdgeMesh& mesh, Index face, Index other) {
  int count = 0;
  for (const Index e : face_edges(mesh, face)) {
    const Index twin = mesh.edge(e).twin;
    if (mesh.edge(twin).face == other) ++count;
  }
  return count;
}

// build_half_edge_mesh() below calls the next four functions in this order. Their parameters and
// results are a suggestion. Change them as you like: only what the header declares is tested.

/// The first fault of the triangles, individually or as a list.
MeshIssue check_triangles([[maybe_unused]] std::span<const Vec3> vertices,
                          [[maybe_unused]] std::span<const Triangle> triangles) {
  // L2.1: Which check makes the next one safe? Report the elements at fault, not only the kind of
  // fault.
  throw NotImplemented("L2.1");
}

/// Stores the two half-edges of each edge next to each other in mesh.edges, or returns the first
/// fault of the edges.
MeshIssue pair_edges([[maybe_unused]] std::span<const Triangle> triangles,
                     [[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.2: Bring the sides of each edge together. What do they have in common?
  throw NotImplemented("L2.2");
}

/// Links the half-edges of each triangle into a loop, and gives each face and vertex one half-edge.
void link_faces([[maybe_unused]] std::span<const Triangle> triangles,
                [[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.3: Find the half-edges that the sides of triangle f have become.
  throw NotImplemented("L2.3");
}

/// Computes the planes of the faces, and rejects a mesh that is inside out.
MeshIssue orient_faces([[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.4: Which quantity of the whole mesh changes its sign if every triangle is reversed?
  throw NotImplemented("L2.4");
}

}  // namespace

MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices,
                               std::span<const Triangle> triangles) {
  if (const MeshIssue issue = check_triangles(vertices, triangles)) return {{}, issue};

  HalfEdgeMesh mesh;
  mesh.vertices.assign(vertices.begin(), vertices.end());
  if (const MeshIssue issue = pair_edges(triangles, mesh)) return {{}, issue};
  link_faces(triangles, mesh);
  if (const MeshIssue issue = orient_faces(mesh)) return {{}, issue};
  return {mesh, {}};
}

Plane polygon_plane([[maybe_unused]] std::span<const Vec3> corners) {
  // L2.5: Add up contributions of all edges, relative to a point of the polygon. Why not to the
  // origin?
  throw NotImplemented("L2.5");
}

Plane face_plane([[maybe_unused]] const HalfEdgeMesh& mesh, [[maybe_unused]] Index face) {
  // L2.5: The corners of a face are the origins of its half-edges.
  throw NotImplemented("L2.5");
}

}  // namespace cs550
