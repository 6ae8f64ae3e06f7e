#include "cs550/mesh_io.hpp"

#include <tiny_obj_loader.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cs550/mesh_validation.hpp"
#include "engine/mesh_files/obj_check.hpp"

namespace cs550 {
namespace {

/// JSON whose numbers are floats: written with the fewest digits that read back as the same bits.
using FloatJson = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                       std::uint64_t, Real>;

FloatJson to_array(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

HalfEdgeMesh mesh_from(const FloatJson& json) {
  HalfEdgeMesh mesh;
  for (const FloatJson& v : json.at("vertices"))
    mesh.vertices.emplace_back(v.at(0), v.at(1), v.at(2));
  mesh.vertex_edge = json.at("vertex_edge").get<std::vector<Index>>();
  for (const FloatJson& e : json.at("half_edges")) {
    const Index twin = mesh.edge_count() ^ 1;
    mesh.edges.push_back({e.at(0), e.at(1), e.at(2), twin, e.at(3)});
  }
  for (const FloatJson& f : json.at("faces")) {
    mesh.faces.push_back({f.at(0), {Vec3(f.at(1), f.at(2), f.at(3)), f.at(4)}});
  }
  return mesh;
}

/// The text of a file, each line up to its "#". The parser knows comments only at the beginning of a line,
/// and reads numbers in the others.
std::string without_comments(std::istream& file) {
  std::string text;
  for (std::string line; std::getline(file, line);) {
    text.append(line, 0, line.find('#')).push_back('\n');
  }
  return text;
}

}  // namespace

SoupResult load_obj(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::error_code unreadable;
  if (!stream || std::filesystem::is_directory(file, unreadable)) {
    return {{}, file.string() + ": cannot be opened; expected an OBJ file"};
  }
  const std::string text = without_comments(stream);
  std::istringstream lines(text);
  if (const std::string fault = first_obj_fault(lines); !fault.empty()) {
    return {{}, file.string() + ": " + fault};
  }
  // From its text and without materials: the parser would open every file that "mtllib" names, also a
  // pipe or a device that has no end.
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, "")) {
    std::string reason = reader.Error();
    reason.resize(reason.find_last_not_of('\n') + 1);
    return {{}, file.string() + ": " + (reason.empty() ? "cannot be read" : reason)};
  }
  TriangleSoup soup;
  const std::vector<Real>& coordinates = reader.GetAttrib().vertices;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    soup.vertices.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const auto& corners = shape.mesh.indices;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      soup.triangles.push_back(
          {corners[i].vertex_index, corners[i + 1].vertex_index, corners[i + 2].vertex_index});
    }
  }
  if (soup.triangles.empty())
    return {
        {},
        file.string() + ": there are no faces in this file; expected lines such as \"f 1 2 3\""};
  return {std::move(soup), {}};
}

std::string to_json(const HalfEdgeMesh& mesh) {
  FloatJson vertices = FloatJson::array();
  for (const Vec3& vertex : mesh.vertices) vertices.push_back(to_array(vertex));
  // Twins are adjacent, so they are not written.
  FloatJson half_edges = FloatJson::array();
  for (const HalfEdge& e : mesh.edges) half_edges.push_back({e.vertex, e.next, e.prev, e.face});
  FloatJson faces = FloatJson::array();
  for (const Face& face : mesh.faces) {
    const Vec3& n = face.plane.normal;
    faces.push_back({face.edge, n.x(), n.y(), n.z(), face.plane.offset});
  }
  return FloatJson{{"vertices", vertices},
                   {"vertex_edge", mesh.vertex_edge},
                   {"half_edges", half_edges},
                   {"faces", faces}}
             .dump() +
         '\n';
}

MeshResult read_mesh_json(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return {{}, file.string() + ": cannot be opened"};
  try {
    return {mesh_from(FloatJson::parse(stream)), {}};
  } catch (const FloatJson::exception& error) {
    return {{}, file.string() + ": is not a half-edge mesh in JSON: " + error.what()};
  }
}

MeshResult load_mesh_json(const std::filesystem::path& file, Real tolerance) {
  MeshResult result = read_mesh_json(file);
  if (!result.error.empty()) return result;
  if (const auto defect = validate(result.mesh, tolerance)) {
    return {{}, file.string() + ": " + defect->sentence};
  }
  return result;
}

}  // namespace cs550
