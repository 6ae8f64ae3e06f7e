// Replaces convex_hull.cpp and obj_check.cpp, which do not compile for the browser: the hull library is
// native code, and emscripten's C++ library reads no floating-point numbers by std::from_chars.
#include "hulls.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "cs550/primitives.hpp"
#include "cs550/scene.hpp"
#include "engine/mesh_files/obj_check.hpp"

namespace cs550::live {

namespace {

struct Hulls {
  nlohmann::json known = nlohmann::json::object();
  nlohmann::json asked = nlohmann::json::object();
  bool is_asking = false;
};

Hulls& hulls() {
  static Hulls all;
  return all;
}

/// A name of a point cloud from the bits of its coordinates (FNV-1a).
std::string key_of(std::span<const Vec3> points) {
  std::uint64_t hash = 14695981039346656037U;
  for (const Vec3& point : points) {
    for (const Real coordinate : point) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof bits);
      hash = (hash ^ bits) * 1099511628211U;
    }
  }
  return fmt::format("{:016x}", hash);
}

/// The points that triangles use, renumbered in their order, as convex_hull() returns them.
TriangleSoup used_part(std::span<const Vec3> points, const std::vector<Index>& corners) {
  std::vector<Index> number(points.size(), no_index);
  for (const Index corner : corners) number.at(corner) = 0;
  TriangleSoup soup;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == no_index) continue;
    number[i] = static_cast<Index>(soup.vertices.size());
    soup.vertices.push_back(points[i]);
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    soup.triangles.push_back({number[corners[i]], number[corners[i + 1]], number[corners[i + 2]]});
  }
  return soup;
}

nlohmann::json coordinates(std::span<const Vec3> points) {
  nlohmann::json all = nlohmann::json::array();
  for (const Vec3& point : points) {
    for (const Real coordinate : point) all.push_back(coordinate);
  }
  return all;
}

}  // namespace

std::string shipped_clouds() {
  hulls().is_asking = true;
  for (const std::string& scene : shipped_scenes()) {
    try {
      find_scene(scene);
    } catch (const std::exception&) {
      // A student's unwritten lab 2: the scene cannot be made in the browser either.
    }
  }
  hulls().is_asking = false;
  return hulls().asked.dump();
}

void learn_hulls(const std::string& text) { hulls().known = nlohmann::json::parse(text); }

}  // namespace cs550::live

namespace cs550 {

SoupResult convex_hull(std::span<const Vec3> points) {
  const std::string key = live::key_of(points);
  live::Hulls& hulls = live::hulls();
  if (hulls.is_asking) {
    hulls.asked[key] = live::coordinates(points);
    return {box_soup(Vec3::Ones()), {}};  // a placeholder, so that the rest of the scene is read
  }
  const auto found = hulls.known.find(key);
  if (found == hulls.known.end()) {
    return {{}, "hulls of other point clouds are not available in the browser; use ./cs550 view"};
  }
  return {live::used_part(points, found->get<std::vector<Index>>()), {}};
}

/// The embedded files have passed the native check.
std::string first_obj_fault(std::istream& /*text*/) { return {}; }

}  // namespace cs550
