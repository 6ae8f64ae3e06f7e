#include "cs550/half_edge_mesh.hpp"
namespace cs550 {
constexpr Index wild = 1 << 28;
MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices,
                               std::span<const Triangle> triangles) {
  MeshBuild build;
  build.mesh.vertices.assign(vertices.begin(), vertices.end());
  build.mesh.vertex_edge.assign(vertices.size(), wild);
  build.mesh.edges.assign(3 * triangles.size(), {wild, -wild, wild, -wild, wild});
  build.mesh.faces.assign(triangles.size(), {-wild, {}});
  return build;
}
Plane polygon_plane(std::span<const Vec3>) { return {}; }
Plane face_plane(const HalfEdgeMesh&, Index) { return {}; }
HalfEdgeMesh merge_coplanar_faces(const HalfEdgeMesh& mesh, Real) {
  HalfEdgeMesh merged = mesh;
  for (Face& face : merged.faces) face.edge = wild;
  return merged;
}
}  // namespace cs550
