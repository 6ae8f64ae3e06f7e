/// @file half_edge_mesh.cpp
/// Lab 2, L2.1 to L2.5: from triangles to a closed mesh; merging.cpp goes on from here. The handout is
/// README.md, beside this file; what each function promises stands in
/// framework/include/cs550/half_edge_mesh.hpp.

#include "cs550/half_edge_mesh.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: how many half-edges lie between two faces. It shows the three moves of this lab:
/// around a face, across an edge to its twin, and from a half-edge to its face.
[[maybe_unused]] int count_shared_edges(const HalfEdgeMesh& mesh, Index face, Index other) {
  int count = 0;
  for (const Index e : face_edges(mesh, face)) {
    const Index twin = mesh.edge(e).twin;
    if (mesh.edge(twin).face == other) ++count;
  }
  return count;
}

// build_half_edge_mesh() below calls the next four functions in this order. Their parameters and
// results are a proposal: change them as you like. Only what the header declares is tested.

/// What is wrong with the triangles, each by itself or as a list.
MeshIssue check_triangles([[maybe_unused]] std::span<const Vec3> vertices,
                          [[maybe_unused]] std::span<const Triangle> triangles) {
  // L2.1, step 1: refuse an empty list, and vertices that are not finite.
  // L2.1, step 2: refuse indices of vertices that do not exist. Only then may you use the indices.
  // L2.1, step 3: refuse triangles without area. The header says how small is none, and for a body
  //               of a millimetre it must mean the same as for one of a kilometre.
  // L2.1, step 4: refuse two triangles with the same three vertices, in whatever order they are.
  //               Comparing all pairs takes minutes for a large mesh.
  // L2.1, step 5: refuse a vertex that no triangle uses.
  // Fill in the elements that show the fault, not only its kind. See README.md, L2.1.
  throw NotImplemented("L2.1");
}

/// Puts the two half-edges of each edge side by side in mesh.edges, or says what is wrong.
MeshIssue pair_edges([[maybe_unused]] std::span<const Triangle> triangles,
                     [[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.2, step 1: list the three sides of each triangle, with what you need to know of each.
  // L2.2, step 2: bring the sides of each edge together. What have they in common?
  // L2.2, step 3: how many sides may an edge have? In which directions do they run?
  //               Look for the kinds of fault one after the other, in the order of the header.
  // L2.2, step 4: give each pair the places 2k and 2k + 1 in mesh.edges, and set vertex and twin.
  // See README.md, L2.2.
  throw NotImplemented("L2.2");
}

/// Ties the half-edges of each triangle into a loop, and gives each face and vertex one of them.
void link_faces([[maybe_unused]] std::span<const Triangle> triangles,
                [[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.3, step 1: find the half-edges that the sides of triangle f have become.
  // L2.3, step 2: set their next, prev and face, and the edge of face f.
  // L2.3, step 3: give each vertex a half-edge that leaves it.
  // See README.md, L2.3.
  throw NotImplemented("L2.3");
}

/// Fills the planes of the faces, and refuses a mesh that is inside out.
MeshIssue orient_faces([[maybe_unused]] HalfEdgeMesh& mesh) {
  // L2.4, step 1: give every face its plane. face_plane() below is L2.5.
  // L2.4, step 2: sum up the signed volume. Which sign has it if the normals point inward?
  // See README.md, L2.4.
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
  // L2.5, step 1: the centroid of the corners. Beware of coordinates that are large beside the
  //               polygon: what is small to begin with can be summed without loss.
  // L2.5, step 2: sum the cross products of the header over the edges of the polygon.
  // L2.5, step 3: a unit normal, and the offset at which the plane goes through the centroid.
  // See README.md, L2.5.
  throw NotImplemented("L2.5");
}

Plane face_plane([[maybe_unused]] const HalfEdgeMesh& mesh, [[maybe_unused]] Index face) {
  // L2.5, step 4: the corners of the face, in the order of its loop, and the plane of that polygon.
  throw NotImplemented("L2.5");
}

}  // namespace cs550
