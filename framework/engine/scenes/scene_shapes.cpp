#include "engine/scenes/scene_shapes.hpp"

#include <algorithm>

#include "cs550/assets.hpp"
#include "cs550/excerpt.hpp"
#include "cs550/mesh_io.hpp"
#include "cs550/mesh_validation.hpp"
#include "cs550/nearest_word.hpp"
#include "engine/scenes/scene_cost.hpp"

namespace cs550 {
namespace {

enum class ShapeKind { Box, Tetrahedron, Prism, Pyramid, Icosphere, Hull, RandomHull, Mesh };

const Names<ShapeKind> shape_kinds = {
    {"box", ShapeKind::Box},
    {"tetrahedron", ShapeKind::Tetrahedron},
    {"prism", ShapeKind::Prism},
    {"pyramid", ShapeKind::Pyramid},
    {"icosphere", ShapeKind::Icosphere},
    {"hull", ShapeKind::Hull},
    {"random_hull", ShapeKind::RandomHull},
    {"mesh", ShapeKind::Mesh},
};

const std::string example_shape = R"({"kind": "box", "half_extents": [0.5, 0.5, 0.5]})";

/// False also for a name that no file can have (empty, too long).
bool is_file(const std::filesystem::path& path) {
  std::error_code none;
  return std::filesystem::is_regular_file(path, none);
}

ShapePtr shape_or_fault(const ShapeResult& result, const std::string& path) {
  if (!result) throw SceneFault(path, "no shape can be made of this: " + result.error);
  return result.shape;
}

ShapePtr shape_of(const TriangleSoup& soup, const std::string& path) {
  return shape_or_fault(make_shape(soup.vertices, soup.triangles), path);
}

ShapePtr hull_of(const std::vector<Vec3>& points, const std::string& path) {
  const SoupResult hull = convex_hull(points);
  if (!hull.error.empty()) throw SceneFault(path, "these points have no hull: " + hull.error);
  return shape_of(hull.soup, path);
}

/// Each subdivision makes four of a face.
int icosphere_vertices(int subdivisions) { return 10 * (1 << 2 * subdivisions) + 2; }

std::vector<Vec3> stretched(std::vector<Vec3> points, const Vec3& factors) {
  for (Vec3& point : points) point = point.cwiseProduct(factors);
  return points;
}

/// A mesh stretched along its axes: normals turn by the inverse factors.
HalfEdgeMesh stretched(HalfEdgeMesh mesh, const Vec3& factors) {
  mesh.vertices = stretched(mesh.vertices, factors);
  for (Face& face : mesh.faces) {
    face.plane.normal = face.plane.normal.cwiseQuotient(factors).normalized();
    face.plane.offset = face.plane.normal.dot(mesh.vertex(mesh.edge(face.edge).vertex));
  }
  return mesh;
}

std::vector<Vec3> read_points(SceneReader& description, SceneCost& cost) {
  const char* example = "[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]";
  description.require("points", example);
  const auto list = description.list("points", example);
  cost.add_cloud(static_cast<std::int64_t>(list.size()), description.path_of("points"));
  std::vector<Vec3> points;
  for (const auto& [point, path] : list) {
    const bool good = point->is_array() && point->size() == 3 &&
                      std::all_of(point->begin(), point->end(), SceneReader::is_number);
    if (!good) {
      throw SceneFault(path, "expected a point of three numbers from -1e6 to 1e6, found " +
                                 SceneReader::excerpt(*point) + "; for example [0, 0, 1]");
    }
    points.emplace_back((*point)[0].get<Real>(), (*point)[1].get<Real>(), (*point)[2].get<Real>());
  }
  return points;
}

}  // namespace

void SceneShapes::define(SceneReader named) {
  for (const std::string& name : named.keys()) {
    named_[name] = make(named.object(name, example_shape));
  }
}

ShapePtr SceneShapes::read(SceneReader& owner, const std::string& key) const {
  owner.require(key, example_shape);
  if (!owner.is_string(key)) return make(owner.object(key, example_shape));

  std::string name;
  owner.read(key, name);
  const auto found = named_.find(name);
  if (found != named_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, shape] : named_) names.push_back(known);
  const std::string nearest = nearest_word(name, names);
  owner.refuse(key,
               "an object, or a name from the scene's \"shapes\"" +
                   (nearest.empty() ? "" : " (did you mean \"" + excerpt(nearest) + "\"?)"),
               example_shape);
}

ShapePtr SceneShapes::random_hull(const SceneReader& owner, int vertices, std::uint32_t seed,
                                  const Vec3& radii) {
  return hull_of(stretched(random_sphere_points(vertices, seed), radii), owner.path());
}

ShapePtr SceneShapes::box(const SceneReader& owner, const Vec3& half_extents) {
  return shape_of(box_soup(half_extents), owner.path());
}

ShapePtr SceneShapes::make(SceneReader description) const {
  const std::string path = description.path();
  ShapeKind kind = ShapeKind::Box;
  description.need("kind", kind, shape_kinds);

  Vec3 half_extents = {Real(0.5), Real(0.5), Real(0.5)};
  Real radius = Real(0.5);
  Real height = 1;
  int sides = 6;
  int subdivisions = 2;
  int vertices = 24;
  std::uint32_t seed = 1;
  constexpr int most_sides = max_face_vertices;
  switch (kind) {
    case ShapeKind::Box:
      description.need("half_extents", half_extents, Range::Positive);
      description.refuse_other_keys();
      cost_.add_points(box_vertices, path);
      return box(description, half_extents);
    case ShapeKind::Tetrahedron:
      description.need("side", height, Range::Positive);
      description.refuse_other_keys();
      cost_.add_points(4, path);
      return shape_of(tetrahedron_soup(height), path);
    case ShapeKind::Prism:
      description.need("sides", sides, 3, most_sides);
      description.need("radius", radius, Range::Positive);
      description.need("height", height, Range::Positive);
      description.refuse_other_keys();
      cost_.add_points(2 * sides, path);
      return shape_of(prism_soup(sides, radius, height / 2), path);
    case ShapeKind::Pyramid:
      description.need("sides", sides, 3, most_sides);
      description.need("radius", radius, Range::Positive);
      description.need("height", height, Range::Positive);
      description.refuse_other_keys();
      cost_.add_points(sides + 1, path);
      return shape_of(pyramid_soup(sides, radius, height), path);
    case ShapeKind::Icosphere:
      description.need("radius", radius, Range::Positive);
      description.read("subdivisions", subdivisions, 0, 4);
      description.refuse_other_keys();
      cost_.add_points(icosphere_vertices(subdivisions), path);
      return shape_of(icosphere_soup(subdivisions, radius), path);
    case ShapeKind::Hull: {
      const std::vector<Vec3> points = read_points(description, cost_);
      description.refuse_other_keys();
      return hull_of(points, path);
    }
    case ShapeKind::RandomHull:
      description.need("vertices", vertices, 4, 1000);
      description.need("radius", radius, Range::Positive);
      description.read("seed", seed);
      description.refuse_other_keys();
      cost_.add_points(vertices, path);
      return random_hull(description, vertices, seed, Vec3::Constant(radius));
    case ShapeKind::Mesh:
      return from_mesh_file(description);
  }
  return nullptr;
}

ShapePtr SceneShapes::from_mesh_file(SceneReader& description) const {
  std::string name = "bunny.obj";
  Vec3 scale = Vec3::Ones();
  description.need("file", name);
  description.read("scale", scale, Range::Positive);
  description.refuse_other_keys();

  std::filesystem::path file = folder_ / name;
  if (!is_file(file)) file = assets_folder() / "meshes" / name;
  if (!is_file(file)) {
    const std::string beside = folder_.empty() ? "." : folder_.string();
    description.refuse(
        "file",
        "an .obj or .json file in " + beside + " or " + (assets_folder() / "meshes").string(),
        "\"bunny.obj\"");
  }
  const std::string path = description.path_of("file");
  cost_.add_file(file, path);
  if (file.extension() == ".json") return from_mesh_json(file, scale, path);
  const SoupResult triangles = load_obj(file);
  if (!triangles.error.empty()) throw SceneFault(path, triangles.error);
  cost_.add_cloud(static_cast<std::int64_t>(triangles.soup.vertices.size()), path);
  return hull_of(stretched(triangles.soup.vertices, scale), path);
}

/// The points are counted before the mesh is checked: that takes faces times vertices.
ShapePtr SceneShapes::from_mesh_json(const std::filesystem::path& file, const Vec3& scale,
                                     const std::string& path) const {
  const MeshResult recorded = read_mesh_json(file);
  if (!recorded.error.empty()) throw SceneFault(path, recorded.error);
  cost_.add_cloud(static_cast<std::int64_t>(recorded.mesh.vertices.size()), path);
  if (const auto defect = validate(recorded.mesh)) {
    throw SceneFault(path, file.string() + ": " + defect->sentence);
  }
  return shape_or_fault(make_shape(stretched(recorded.mesh, scale)), path);
}

}  // namespace cs550
