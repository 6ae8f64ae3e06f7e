#include "engine/mesh_files/obj_check.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

#include "cs550/excerpt.hpp"
#include "cs550/math.hpp"

namespace cs550 {
namespace {

/// What a line says that can only be judged at the end of the file: the largest vertex number so far.
struct LargestNumber {
  long long number = 0;
  int line = 0;
};

template <class Number>
bool parse_all(std::string_view word, Number& value) {
  if (word.starts_with("+-")) return false;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && rest == word.data() + word.size();
}

std::string at_line(int line, const std::string& sentence) {
  return "line " + std::to_string(line) + ": " + sentence;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The parser multiplies the digits by the power of ten in double precision, and each may overflow where the
/// number itself is small: "0e3192" becomes NaN.
bool parser_overflows(std::string_view word) {
  constexpr std::size_t max_letters = 64;
  constexpr int max_exponent = 99;
  const std::size_t mark = word.find_first_of("eE");
  int exponent = 0;
  if (mark != std::string_view::npos && !parse_all(word.substr(mark + 1), exponent)) return true;
  return word.size() > max_letters || std::abs(exponent) > max_exponent;
}

bool is_coordinate(std::string_view word) {
  Real value = 0;
  return parse_all(word, value) && std::isfinite(value) && !parser_overflows(word);
}

std::string vertex_fault(const std::vector<std::string>& words, int line) {
  if (words.size() < 4) {
    return at_line(
        line, "expected three coordinates after \"v\", found " + std::to_string(words.size() - 1));
  }
  for (std::size_t i = 1; i < 4; ++i) {
    if (!is_coordinate(words[i])) {
      return at_line(line,
                     "expected a coordinate such as 1.5, found \"" + excerpt(words[i]) + "\"");
    }
  }
  return {};
}

std::string face_fault(const std::vector<std::string>& words, int line, long long vertices,
                       LargestNumber& largest) {
  const std::size_t corners = words.size() - 1;
  if (corners < 3 || corners > max_obj_face_corners) {
    return at_line(line, "expected a face of 3 to " + std::to_string(max_obj_face_corners) +
                             " corners, found " + std::to_string(corners) +
                             (corners < 3 ? "" : "; split it into triangles"));
  }
  for (std::size_t i = 1; i <= corners; ++i) {
    const std::string word = words[i].substr(0, words[i].find('/'));
    long long number = 0;
    const bool is_number = parse_all(std::string_view(word), number);
    if (!is_number || number == 0 || number < -vertices) {
      return at_line(line,
                     "expected the number of a vertex, counted from 1 (or from -1 backwards), "
                     "found \"" +
                         excerpt(words[i]) + "\"");
    }
    if (number > largest.number) largest = {number, line};
  }
  return {};
}

/// The parser begins a new line after a carriage return, also in the middle of a line, ends one at a zero,
/// and takes a form feed for a letter.
std::string control_fault(const std::string& content, int line) {
  const auto is_control = [](unsigned char letter) {
    return (letter < 0x20 && letter != '\t') || letter == 0x7f;
  };
  const auto place = std::find_if(content.begin(), content.end(), is_control);
  if (place == content.end()) return {};
  if (*place != '\r') {
    return at_line(line, "expected plain text, found the control character with the code " +
                             std::to_string(static_cast<unsigned char>(*place)) + "; remove it");
  }
  if (place + 1 == content.end()) return {};
  return at_line(line,
                 "expected a line feed at the end of a line, found a carriage return in it; "
                 "replace each by a line feed");
}

/// Whether the parser begins a group here: it wants a blank after the letter. It then splits the faces of the last
/// group that have more than three corners. After "mtllib", it may also begin one at each "usemtl".
bool begins_group(const std::vector<std::string>& words, const std::string& line,
                  bool has_materials) {
  if (has_materials && words[0].starts_with("usemtl")) return true;
  if (words[0] != "g" && words[0] != "o") return false;
  return line.find_first_of(" \t", line.find(words[0])) != std::string::npos;
}

}  // namespace

std::string first_obj_fault(std::istream& text) {
  LargestNumber in_triangles;
  LargestNumber in_polygons;  // of four corners and more
  long long vertices = 0;
  bool has_materials = false;
  int early_face = 0;
  std::string content;
  for (int line = 1; std::getline(text, content); ++line) {
    if (std::string fault = control_fault(content, line); !fault.empty()) return fault;
    const std::vector<std::string> words = words_of(content);
    if (words.empty()) continue;
    std::string fault;
    if (words[0] == "v") {
      fault = vertex_fault(words, line);
      ++vertices;
    } else if (words[0] == "f") {
      fault = face_fault(words, line, vertices, words.size() > 4 ? in_polygons : in_triangles);
    } else if (words[0] == "mtllib") {
      has_materials = true;
    } else if (early_face == 0 && in_polygons.number > vertices &&
               begins_group(words, content, has_materials)) {
      early_face = in_polygons.line;
    }
    if (!fault.empty()) return fault;
  }
  const LargestNumber& largest =
      in_polygons.number > in_triangles.number ? in_polygons : in_triangles;
  if (largest.number > vertices) {
    return at_line(largest.line, "a face names vertex " + std::to_string(largest.number) +
                                     ", but the file has " + std::to_string(vertices) +
                                     (vertices == 1 ? " vertex" : " vertices"));
  }
  if (early_face > 0) {
    return at_line(early_face, "a face comes before its vertices; move the \"v\" lines to the top");
  }
  return {};
}

}  // namespace cs550
