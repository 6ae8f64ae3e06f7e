#include "helpers/fixtures.hpp"

#include <map>
#include <stdexcept>

#include "cs550/mesh_io.hpp"

namespace cs550::test {
namespace {

HalfEdgeMesh load(const std::string& name) {
  // Convexity is checked where a shape is made: some meshes are not convex on purpose.
  MeshResult result =
      load_mesh_json(std::string(CS550_TEST_DATA) + "/meshes/" + name + ".json", HUGE_VALF);
  if (!result.error.empty()) throw std::runtime_error("fixture: " + result.error);
  return std::move(result.mesh);
}

ShapePtr make(const std::string& name) {
  const ShapeResult result = make_shape(fixture_mesh(name));
  if (!result) throw std::runtime_error("fixture " + name + ": " + result.error);
  return result.shape;
}

}  // namespace

const HalfEdgeMesh& fixture_mesh(std::string_view name) {
  static std::map<std::string, HalfEdgeMesh, std::less<>> meshes;
  const auto known = meshes.find(name);
  return known != meshes.end() ? known->second
                               : meshes.emplace(name, load(std::string(name))).first->second;
}

ShapePtr fixture_shape(const std::string& name) {
  static std::map<std::string, ShapePtr> shapes;
  const auto known = shapes.find(name);
  return known != shapes.end() ? known->second : shapes.emplace(name, make(name)).first->second;
}

}  // namespace cs550::test
