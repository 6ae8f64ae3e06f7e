#include "engine/scenes/scene_cost.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "engine/scenes/scene_reader.hpp"

namespace cs550 {
namespace {

// Bytes of memory, measured with ./cs550 demo, which keeps the world of the last step beside the new one.
constexpr int bytes_of_a_body = 2000;
constexpr int bytes_of_a_point = 500;
constexpr int bytes_of_a_pair = 3500;
/// Per byte of a text that consists of empty objects.
constexpr int bytes_of_a_letter = 32;

constexpr std::int64_t megabyte = 1000000;

std::string at_most(std::int64_t limit, const std::string& things, std::int64_t found,
                    const std::string& variable) {
  return "expected at most " + std::to_string(limit) + " " + things + ", found " +
         std::to_string(found) + "; set the environment variable " + variable + " to allow more";
}

void refuse_more(std::int64_t found, std::int64_t limit, const std::string& things,
                 const std::string& variable, const std::string& path) {
  if (found > limit) throw SceneFault(path, at_most(limit, things, found, variable));
}

/// The coordinate in which the bodies are farthest apart, so that a sweep along it meets few at once.
int longest_axis(const std::vector<Bounds>& bounds) {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (const Bounds& box : bounds) {
    const Eigen::Array3d place = box.lower.cast<double>().array();
    sum += place;
    squares += place.square();
  }
  int axis = 0;
  (squares - sum.square() / static_cast<double>(bounds.size())).maxCoeff(&axis);
  return axis;
}

/// How many pairs of bodies have overlapping bounds. Counts no further than the body that exceeds `most`.
std::int64_t overlapping_pairs(const Scene& scene, std::int64_t most) {
  std::vector<Bounds> bounds;
  bounds.reserve(scene.bodies.size());
  for (const BodyDef& body : scene.bodies) {
    bounds.push_back(world_bounds({body.shape.get(), body.pose}));
  }
  const int axis = longest_axis(bounds);
  std::sort(bounds.begin(), bounds.end(),
            [axis](const Bounds& a, const Bounds& b) { return a.lower[axis] < b.lower[axis]; });
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < bounds.size() && pairs <= most; ++i) {
    for (std::size_t k = i + 1; k < bounds.size(); ++k) {
      if (bounds[k].lower[axis] > bounds[i].upper[axis]) break;
      if (bounds[k].overlaps(bounds[i])) ++pairs;
    }
  }
  return pairs;
}

}  // namespace

void SceneCost::add_file(const std::filesystem::path& file, const std::string& path) {
  std::error_code no_size;  // of a pipe
  const std::uintmax_t size = std::filesystem::file_size(file, no_size);
  if (!no_size)
    add_memory(static_cast<std::int64_t>(size), bytes_of_a_letter, "bytes of text", path);
}

void SceneCost::add_bodies(std::int64_t count, const std::string& path) {
  bodies_ += count;
  refuse_more(bodies_, limits_.bodies, "bodies in a scene", "CS550_MAX_BODIES", path);
  add_memory(count, bytes_of_a_body, "bodies", path);
}

void SceneCost::add_cloud(std::int64_t count, const std::string& path) {
  refuse_more(count, limits_.hull_points, "points", "CS550_MAX_HULL_POINTS", path);
  add_points(count, path);
}

void SceneCost::add_points(std::int64_t count, const std::string& path) {
  points_ += count;
  refuse_more(points_, limits_.total_points, "vertices of all shapes of a scene",
              "CS550_MAX_TOTAL_POINTS", path);
  add_memory(count, bytes_of_a_point, "vertices", path);
}

void SceneCost::add_pairs(const Scene& scene) {
  const std::int64_t pairs = overlapping_pairs(scene, limits_.pairs);
  if (pairs > limits_.pairs) {
    throw SceneFault("", at_most(limits_.pairs, "pairs of bodies with overlapping bounds", pairs,
                                 "CS550_MAX_PAIRS") +
                             "; or spread the bodies");
  }
  add_memory(pairs, bytes_of_a_pair, "pairs of bodies with overlapping bounds", "");
}

void SceneCost::add_memory(std::int64_t count, int bytes, const std::string& things,
                           const std::string& path) {
  bytes_ += count * bytes;
  if (bytes_ <= limits_.memory_mb * megabyte) return;
  throw SceneFault(path, "expected a scene that needs at most " +
                             std::to_string(limits_.memory_mb) + " MB of memory, found about " +
                             std::to_string(bytes_ / megabyte) + " MB with these " +
                             std::to_string(count) + " " + things +
                             "; set the environment variable CS550_MAX_MEMORY_MB to allow more");
}

}  // namespace cs550
