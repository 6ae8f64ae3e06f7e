#include "engine/scenes/scene_limits.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <charconv>
#include <cstdio>
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

/// Of the principal inertias of one body.
constexpr double largest_inertia_ratio = 1e6;
/// Of the masses of two dynamic bodies.
constexpr double largest_mass_ratio = 1e9;

std::string in_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

double mass_of(const BodyDef& body) {
  return static_cast<double>(body.mass ? *body.mass : body.density * body.shape->volume);
}

double inertia_ratio(const ConvexShape& shape) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(shape.unit_inertia.cast<double>(),
                                                                 Eigen::EigenvaluesOnly);
  return principal.eigenvalues().maxCoeff() / principal.eigenvalues().minCoeff();
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

void refuse_beyond_float(const Scene& scene, std::size_t listed) {
  const auto path = [&](std::size_t i) {
    return i < listed ? "/bodies/" + std::to_string(i) : std::string("/generators");
  };
  std::size_t lightest = scene.bodies.size();
  std::size_t heaviest = lightest;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    if (body.kind != BodyKind::Dynamic) continue;
    const double ratio = inertia_ratio(*body.shape);
    // Not a number is beyond the limit too.
    if (!(ratio <= largest_inertia_ratio)) {
      throw SceneFault(path(i),
                       "expected a shape whose moments of inertia differ by a factor of at most " +
                           in_digits(largest_inertia_ratio) + ", found " + in_digits(ratio) +
                           "; make the body thicker: a needle may be 1 : 1400");
    }
    if (lightest == scene.bodies.size()) lightest = heaviest = i;
    if (mass_of(body) < mass_of(scene.bodies[lightest])) lightest = i;
    if (mass_of(body) > mass_of(scene.bodies[heaviest])) heaviest = i;
  }
  if (lightest == scene.bodies.size()) return;
  const double least = mass_of(scene.bodies[lightest]);
  const double most = mass_of(scene.bodies[heaviest]);
  if (most <= largest_mass_ratio * least) return;
  throw SceneFault(path(lightest), "expected masses that differ by a factor of at most " +
                                       in_digits(largest_mass_ratio) + ", found " +
                                       in_digits(least) + " kg beside " + in_digits(most) +
                                       " kg of " + path(heaviest) +
                                       "; state a \"mass\" for one of the two");
}

}  // namespace cs550
