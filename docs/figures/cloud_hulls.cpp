#include "cloud_hulls.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <vector>

#include "cs550/primitives.hpp"

namespace cs550::book {

namespace {

/// The corners of a hull's triangles as indices of the points. The hull keeps the points' order.
std::vector<Index> corners_of(std::span<const Vec3> points, const TriangleSoup& hull) {
  std::vector<Index> place;
  for (std::size_t i = 0; i < points.size() && place.size() < hull.vertices.size(); ++i) {
    if (points[i] == hull.vertices[place.size()]) place.push_back(static_cast<Index>(i));
  }
  std::vector<Index> corners;
  for (const Triangle& triangle : hull.triangles) {
    for (const Index v : triangle) corners.push_back(place.at(v));
  }
  return corners;
}

std::vector<Vec3> read_points(const nlohmann::json& coordinates) {
  std::vector<Vec3> points(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    points.at(i / 3)[static_cast<Eigen::Index>(i % 3)] = coordinates[i].get<Real>();
  }
  return points;
}

}  // namespace

void answer_clouds(const std::string& clouds, const std::string& output) {
  nlohmann::json hulls = nlohmann::json::object();
  const nlohmann::json asked = nlohmann::json::parse(std::ifstream(clouds));
  for (const auto& [key, coordinates] : asked.items()) {
    const std::vector<Vec3> points = read_points(coordinates);
    const SoupResult hull = convex_hull(points);
    if (!hull.error.empty())
      throw std::runtime_error(fmt::format("{}, {}: {}", clouds, key, hull.error));
    hulls[key] = corners_of(points, hull.soup);
  }
  std::ofstream file(output);
  file << hulls;
  if (!file.flush()) throw std::runtime_error("cannot write " + output);
}

}  // namespace cs550::book
