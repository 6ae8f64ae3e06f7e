#include "helpers/recorded_meshes.hpp"

#include <stdexcept>

#include "cs550/mesh_io.hpp"

namespace cs550::test {
namespace {

constexpr std::uint32_t hull_seed = 550;

/// Every triangle is a face of its own.
HalfEdgeMesh unmerged(const TriangleSoup& soup) {
  const MeshBuild build = build_half_edge_mesh(soup.vertices, soup.triangles);
  if (build.issue) throw std::runtime_error(describe(build.issue));
  return build.mesh;
}

HalfEdgeMesh merged(const TriangleSoup& soup) { return merge_coplanar_faces(unmerged(soup)); }

HalfEdgeMesh hull(const std::vector<Vec3>& points) {
  const SoupResult result = convex_hull(points);
  if (!result.error.empty()) throw std::runtime_error(result.error);
  return merged(result.soup);
}

HalfEdgeMesh hull_of_file(const std::string& file) {
  const SoupResult loaded = load_obj(std::string(CS550_ASSETS) + "/meshes/" + file);
  if (!loaded.error.empty()) throw std::runtime_error(loaded.error);
  std::vector<Vec3> points = loaded.soup.vertices;
  Bounds bounds;
  for (const Vec3& point : points) bounds.include(point);
  for (Vec3& point : points) point = (point - bounds.center()) / bounds.extent().maxCoeff();
  return hull(points);
}

std::vector<Vec3> dodecahedron_points() {
  const Real golden = (1 + std::sqrt(Real(5))) / 2;
  std::vector<Vec3> points = box_soup(Vec3::Ones()).vertices;
  for (const Real a : {-1 / golden, 1 / golden}) {
    for (const Real b : {-golden, golden}) {
      points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    }
  }
  return points;
}

/// Two pyramids of different heights on a common base, with a lower ridge between them.
TriangleSoup twin_peaks_soup() {
  return {{{-2, -1, 0},
           {0, -1, 0.5},
           {2, -1, 0},
           {2, 1, 0},
           {0, 1, 0.5},
           {-2, 1, 0},
           {-1, 0, 1},
           {1, 0, 2}},
          {{0, 1, 6},
           {1, 4, 6},
           {4, 5, 6},
           {5, 0, 6},
           {1, 2, 7},
           {2, 3, 7},
           {3, 4, 7},
           {4, 1, 7},
           {0, 2, 1},
           {3, 5, 4},
           {0, 5, 3},
           {0, 3, 2}}};
}

}  // namespace

std::vector<RecordedMesh> record_meshes() {
  const TriangleSoup cube = box_soup(Vec3::Constant(Real(0.5)));
  std::vector<RecordedMesh> meshes = {
      {"cube", merged(cube)},
      {"box_1x2x3", merged(box_soup({0.5F, 1, 1.5F}))},
      {"box_0.4x1x2", merged(box_soup({0.2F, 0.5F, 1}))},
      {"slab", merged(box_soup({1, 1, 0.05F}))},
      {"needle", merged(box_soup({0.01F, 0.01F, 1}))},
      {"corner_tetrahedron", merged(tetrahedron_soup(1))},
      {"regular_tetrahedron", hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})},
      {"sliver", hull({{1, 0, 0.01F}, {-1, 0, 0.01F}, {0, 1, -0.01F}, {0, -1, -0.01F}})},
      {"prism3", merged(prism_soup(3, 1, 0.5F))},
      {"prism6", merged(prism_soup(6, 1, 0.5F))},
      {"prism32", merged(prism_soup(32, 1, 0.5F))},
      {"pyramid4", merged(pyramid_soup(4, 1, 1))},
      {"dodecahedron", hull(dodecahedron_points())},
      {"bunny_hull", hull_of_file("bunny.obj")},
      {"teapot_hull", hull_of_file("teapot.obj")},
      {"triangulated_cube", unmerged(cube)},
      {"twin_peaks", unmerged(twin_peaks_soup())},
  };
  for (int i = 0; i <= 3; ++i) {
    meshes.push_back({"icosphere" + std::to_string(i), merged(icosphere_soup(i, 1))});
  }
  for (int count = 8; count <= 256; count *= 2) {
    meshes.push_back(
        {"hull" + std::to_string(count), hull(random_sphere_points(count, hull_seed))});
  }
  return meshes;
}

}  // namespace cs550::test
