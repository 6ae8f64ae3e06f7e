// build_half_edge_mesh() and merge_coplanar_faces(): any triangles are a mesh or have a named fault.

#include "cs550/half_edge_mesh.hpp"
#include "cs550/mesh_validation.hpp"
#include "points.hpp"
#include "promise.hpp"

using namespace cs550;

namespace {

std::vector<Triangle> take_triangles(FuzzedDataProvider& bytes) {
  std::vector<Triangle> triangles;
  while (bytes.remaining_bytes() >= 3) {
    Triangle triangle;
    for (Index& v : triangle) v = bytes.ConsumeIntegralInRange<Index>(-128, 127);
    triangles.push_back(triangle);
  }
  return triangles;
}

bool is_convex(const HalfEdgeMesh& mesh) { return !validate(mesh); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const std::vector<Vec3> vertices = fuzz::take_points(bytes, 32);
  const std::vector<Triangle> triangles = take_triangles(bytes);
  const MeshBuild build = build_half_edge_mesh(vertices, triangles);
  if (build.issue) {
    fuzz::promise(build.mesh.faces.empty(), "a refused mesh is empty");
    fuzz::promise(!describe(build.issue).empty(), "a fault has a description");
    return 0;
  }
  fuzz::promise(build.mesh.faces.size() == triangles.size(), "face f is triangle f");
  if (!is_convex(build.mesh)) return 0;
  const HalfEdgeMesh merged = merge_coplanar_faces(build.mesh);
  fuzz::promise(is_convex(merged), "merging keeps a convex mesh valid");
  const HalfEdgeMesh again = merge_coplanar_faces(merged);
  fuzz::promise(again.faces.size() == merged.faces.size(), "merging the result changes nothing");
  return 0;
}
