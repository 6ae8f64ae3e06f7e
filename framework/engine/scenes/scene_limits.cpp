#include "engine/scenes/scene_limits.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "engine/scenes/scene_reader.hpp"

namespace cs550 {
namespace {

void replace_from_environment(const char* variable, int& limit) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return;
  int value = 0;
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, value);
  if (error == std::errc() && rest == end && value > 0) limit = value;
}

}  // namespace

SceneLimits SceneLimits::from_environment() {
  SceneLimits limits;
  replace_from_environment("CS550_MAX_BODIES", limits.bodies);
  replace_from_environment("CS550_MAX_HULL_POINTS", limits.hull_points);
  replace_from_environment("CS550_MAX_TOTAL_POINTS", limits.total_points);
  replace_from_environment("CS550_MAX_PAIRS", limits.pairs);
  return limits;
}

std::string beyond_limit(std::int64_t found, int limit, const std::string& things,
                         const std::string& variable) {
  return "expected at most " + std::to_string(limit) + " " + things + ", found " +
         std::to_string(found) + "; set the environment variable " + variable + " to allow more";
}

void refuse_many_pairs(const Scene& scene, const SceneLimits& limits) {
  std::vector<Bounds> bounds;
  bounds.reserve(scene.bodies.size());
  for (const BodyDef& body : scene.bodies) {
    bounds.push_back(world_bounds({body.shape.get(), body.pose}));
  }
  std::sort(bounds.begin(), bounds.end(),
            [](const Bounds& a, const Bounds& b) { return a.lower.x() < b.lower.x(); });
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    for (std::size_t k = i + 1; k < bounds.size(); ++k) {
      if (bounds[k].lower.x() > bounds[i].upper.x()) break;
      if (bounds[k].overlaps(bounds[i])) ++pairs;
    }
    if (pairs > limits.pairs) {
      throw SceneFault("",
                       beyond_limit(pairs, limits.pairs, "pairs of bodies with overlapping bounds",
                                    "CS550_MAX_PAIRS") +
                           "; or spread the bodies");
    }
  }
}

}  // namespace cs550
