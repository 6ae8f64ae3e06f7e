#include "helpers/fixtures.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>

#include "cs550/mesh_io.hpp"

namespace cs550::test {
namespace {

HalfEdgeMesh load(const std::string& name) {
  // Convexity is checked when a shape is made. Some meshes are deliberately not convex.
  MeshResult result = load_mesh_json(fixture_file(name), HUGE_VALF);
  if (!result.error.empty()) throw std::runtime_error("fixture: " + result.error);
  return std::move(result.mesh);
}

ShapePtr make(const std::string& name) {
  const ShapeResult result = make_shape(fixture_mesh(name));
  if (!result) throw std::runtime_error("fixture " + name + ": " + result.error);
  return result.shape;
}

}  // namespace

std::string fixture_file(const std::string& name) {
  const std::string file = "/meshes/" + name + ".json";
  const std::string shared = CS550_ASSETS + file;
  return std::filesystem::exists(shared) ? shared : CS550_TEST_DATA + file;
}

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
