#include "cs550/mesh_io.hpp"

#include <tiny_obj_loader.h>

#include <fstream>
#include <sstream>
#include <string_view>

#include "engine/mesh_files/obj_check.hpp"

namespace cs550 {
namespace {

/// The text of a file, each line up to its "#". The parser knows comments only at the beginning of a line,
/// and reads numbers in the others. It takes a mark of UTF-8 for a part of the first word.
std::string without_comments(std::istream& file) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  std::string text;
  for (std::string line; std::getline(file, line);) {
    text.append(line, 0, line.find('#')).push_back('\n');
  }
  if (text.starts_with(mark)) text.erase(0, mark.size());
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

}  // namespace cs550
