// Half-edge meshes as JSON, the format of recorded meshes.
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cs550/excerpt.hpp"
#include "cs550/mesh_io.hpp"
#include "cs550/mesh_validation.hpp"

namespace cs550 {
namespace {

/// JSON whose numbers are floats: written with the fewest digits that read back as the same bits.
using FloatJson = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                       std::uint64_t, Real>;

FloatJson to_array(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

[[noreturn]] void refuse(const std::string& path, const std::string& expected,
                         const FloatJson& found) {
  // Lists are not repeated: they may be deep, and printing one is recursive.
  const std::string text =
      found.is_structured()
          ? std::string("an ") + found.type_name()
          : excerpt(found.dump(-1, ' ', false, FloatJson::error_handler_t::replace));
  throw std::runtime_error(path + ": expected " + expected + ", found " + text);
}

const FloatJson& list_under(const FloatJson& mesh, const std::string& key) {
  if (!mesh.is_object()) refuse("/", "an object in braces", mesh);
  if (!mesh.contains(key)) {
    throw std::runtime_error("/: the key \"" + key +
                             "\" is missing; expected vertices, vertex_edge, half_edges and faces");
  }
  const FloatJson& list = mesh.at(key);
  if (!list.is_array()) refuse('/' + key, "a list in brackets", list);
  return list;
}

Real to_number(const FloatJson& value, const std::string& path) {
  if (!value.is_number() || !std::isfinite(value.get<Real>())) refuse(path, "a number", value);
  return value.get<Real>();
}

Index to_index(const FloatJson& value, const std::string& path) {
  if (!value.is_number_integer() || value < 0 || value > std::numeric_limits<Index>::max()) {
    refuse(path, "the index of an element, a whole number counted from 0", value);
  }
  return value.get<Index>();
}

/// One row of a list, whose items are read by their places.
class Row {
 public:
  Row(const FloatJson& list, const std::string& key, std::size_t place, std::size_t size)
      : row_(list[place]), path_('/' + key + '/' + std::to_string(place)) {
    if (!row_.is_array() || row_.size() != size) {
      refuse(path_, "a list of " + std::to_string(size) + " numbers", row_);
    }
  }
  Real number(std::size_t i) const { return to_number(row_[i], path_of(i)); }
  Index index(std::size_t i) const { return to_index(row_[i], path_of(i)); }

 private:
  std::string path_of(std::size_t i) const { return path_ + '/' + std::to_string(i); }

  const FloatJson& row_;
  std::string path_;
};

std::vector<Row> rows(const FloatJson& mesh, const std::string& key, std::size_t size) {
  const FloatJson& list = list_under(mesh, key);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < list.size(); ++i) rows.emplace_back(list, key, i, size);
  return rows;
}

HalfEdgeMesh mesh_from(const FloatJson& json) {
  HalfEdgeMesh mesh;
  for (const Row& v : rows(json, "vertices", 3)) {
    mesh.vertices.emplace_back(v.number(0), v.number(1), v.number(2));
  }
  const std::string first_edges = "vertex_edge";
  for (const FloatJson& edge : list_under(json, first_edges)) {
    const std::string place = std::to_string(mesh.vertex_edge.size());
    mesh.vertex_edge.push_back(to_index(edge, '/' + first_edges + '/' + place));
  }
  for (const Row& e : rows(json, "half_edges", 4)) {
    const Index twin = mesh.edge_count() ^ 1;
    mesh.edges.push_back({e.index(0), e.index(1), e.index(2), twin, e.index(3)});
  }
  for (const Row& f : rows(json, "faces", 5)) {
    mesh.faces.push_back({f.index(0), {Vec3(f.number(1), f.number(2), f.number(3)), f.number(4)}});
  }
  return mesh;
}

}  // namespace

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
  const std::string where = file.string() + ": this is no half-edge mesh in JSON: ";
  try {
    return {mesh_from(FloatJson::parse(stream)), {}};
  } catch (const FloatJson::exception& error) {
    const std::string_view reason = error.what();  // after the parser's own number for it
    return {{}, where + excerpt(reason.substr(reason.find("] ") + 2), 300)};
  } catch (const std::runtime_error& fault) {
    return {{}, where + fault.what()};
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
