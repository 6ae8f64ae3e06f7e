#include "engine/scenes/scene_limits.hpp"

#include <Eigen/Eigenvalues>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <utility>

#include "engine/scenes/scene_reader.hpp"

namespace cs550 {
namespace {

/// Replaces a limit by the value of an environment variable. @returns what is wrong with that; empty if nothing
std::string replace_from_environment(const std::string& variable, int& limit) {
  const char* text = std::getenv(variable.c_str());
  if (text == nullptr) return {};
  int value = 0;
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, value);
  if (error != std::errc() || rest != end || value <= 0) {
    return "the environment variable " + variable + ": expected a whole number from 1 to " +
           std::to_string(std::numeric_limits<int>::max()) + ", found \"" + excerpt(text) +
           "\"; for example " + variable + "=" + std::to_string(limit);
  }
  limit = value;
  return {};
}

/// Of the principal inertias of one body.
constexpr double largest_inertia_ratio = 1e6;
/// Of the masses of two dynamic bodies.
constexpr double largest_mass_ratio = 1e9;
/// Of one body (kg), as World::add_body() states it.
constexpr double largest_mass = 1e15;
/// Of one body (kg m/s): the engine squares it.
constexpr double largest_momentum = 1e18;
/// Of one body (kg m²). The engine uses the inverse, too.
constexpr double smallest_inertia = 1e-30;
constexpr double largest_inertia = 1e33;
/// Of one body at its farthest point (1/kg): by how much an impulse of 1 N·s there changes the velocity there.
/// The engine multiplies two such numbers, of levers that may be longer.
constexpr double largest_response = 1e18;
/// Of one body (J).
constexpr double largest_spin_energy = 1e30;

std::string in_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

double mass_of(const BodyDef& body) {
  return static_cast<double>(body.mass ? *body.mass : body.density * body.shape->volume);
}

/// Moments of inertia per density about the principal axes, the smallest first.
Eigen::Vector3d principal_moments(const ConvexShape& shape) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(shape.unit_inertia.cast<double>(),
                                                                 Eigen::EigenvaluesOnly);
  return principal.eigenvalues();
}

/// Kinetic energy of the rotation (J).
double spin_energy(const BodyDef& body, double density) {
  const Eigen::Vector3d w = body.pose.unrotate(body.angular_velocity).cast<double>();
  return 0.5 * density * w.dot(body.shape->unit_inertia.cast<double>() * w);
}

/// Of the farthest point of a body to an impulse there, at most (1/kg).
double response(const BodyDef& body, double smallest_moment) {
  const auto radius = static_cast<double>(body.shape->radius);
  return 1 / mass_of(body) + radius * radius / smallest_moment;
}

// Not a number is beyond a limit, too.

void refuse_thin(const Eigen::Vector3d& moments, const std::string& path) {
  const double ratio = moments.maxCoeff() / moments.minCoeff();
  if (ratio <= largest_inertia_ratio) return;
  throw SceneFault(path,
                   "expected a shape whose moments of inertia differ by a factor of at most " +
                       in_digits(largest_inertia_ratio) + ", found " + in_digits(ratio) +
                       "; make the body thicker: a needle may be 1 : 1400");
}

void refuse_above(double found, double limit, const std::string& path, const std::string& quantity,
                  const std::string& advice) {
  if (found <= limit) return;
  throw SceneFault(path, "expected " + quantity + " of at most " + in_digits(limit) + ", found " +
                             in_digits(found) + "; " + advice);
}

void refuse_moments(const BodyDef& body, const Eigen::Vector3d& moments, const std::string& path) {
  const double density = mass_of(body) / static_cast<double>(body.shape->volume);
  const double smallest = density * moments.minCoeff();
  if (!(smallest >= smallest_inertia)) {
    throw SceneFault(path, "expected moments of inertia of at least " +
                               in_digits(smallest_inertia) + " kg m², found " +
                               in_digits(smallest) + "; make the body larger or heavier");
  }
  const double found = response(body, smallest);
  refuse_above(found, largest_response, path,
               "1/mass + radius²/(smallest moment of inertia) in 1/kg",
               "for example \"density\": " + in_digits(2 * density * found / largest_response));
  refuse_above(density * moments.maxCoeff(), largest_inertia, path, "moments of inertia in kg m²",
               "make the body smaller or lighter");
}

void refuse_speeds(const BodyDef& body, const Scene& scene, const std::string& path) {
  const double mass = mass_of(body);
  const double speed = body.linear_velocity.cast<double>().norm() +
                       static_cast<double>(scene.h) * scene.settings.gravity.cast<double>().norm();
  refuse_above(mass * speed, largest_momentum, path, "a momentum in kg m/s after the first step",
               "for example \"linear_velocity\": [0, 0, 0]");
  refuse_above(spin_energy(body, mass / static_cast<double>(body.shape->volume)),
               largest_spin_energy, path, "a kinetic energy of the rotation in J",
               "for example \"angular_velocity\": [0, 0, 0]");
  const double surface_speed =
      static_cast<double>(body.shape->radius) * body.angular_velocity.cast<double>().norm();
  refuse_above(mass * surface_speed, largest_momentum, path,
               "a mass times the speed of its surface by rotation in kg m/s",
               "for example \"angular_velocity\": [0, 0, 0]");
}

/// What the first step multiplies. Each number of the scene is in its range, but their products may not
/// be: an angular momentum is density × length⁵ × speed.
void refuse_overflow(const BodyDef& body, const Eigen::Vector3d& moments, const Scene& scene,
                     const std::string& path) {
  const double mass = mass_of(body);
  const double density = mass / static_cast<double>(body.shape->volume);
  refuse_above(mass, largest_mass, path, "a mass in kg",
               "for example \"density\": " + in_digits(density / mass * largest_mass / 2));
  refuse_moments(body, moments, path);
  refuse_speeds(body, scene, path);
}

}  // namespace

SceneLimits SceneLimits::from_environment() {
  SceneLimits limits;
  const std::pair<const char*, int*> variables[] = {
      {"CS550_MAX_BODIES", &limits.bodies},
      {"CS550_MAX_HULL_POINTS", &limits.hull_points},
      {"CS550_MAX_TOTAL_POINTS", &limits.total_points},
      {"CS550_MAX_PAIRS", &limits.pairs},
      {"CS550_MAX_MEMORY_MB", &limits.memory_mb},
  };
  for (const auto& [variable, limit] : variables) {
    const std::string fault = replace_from_environment(variable, *limit);
    if (limits.fault.empty()) limits.fault = fault;
  }
  return limits;
}

void refuse_beyond_float(const Scene& scene, const std::vector<std::string>& paths) {
  std::size_t lightest = scene.bodies.size();
  std::size_t heaviest = lightest;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    if (body.kind != BodyKind::Dynamic) continue;
    const Eigen::Vector3d moments = principal_moments(*body.shape);
    refuse_thin(moments, paths[i]);
    refuse_overflow(body, moments, scene, paths[i]);
    if (lightest == scene.bodies.size()) lightest = heaviest = i;
    if (mass_of(body) < mass_of(scene.bodies[lightest])) lightest = i;
    if (mass_of(body) > mass_of(scene.bodies[heaviest])) heaviest = i;
  }
  if (lightest == scene.bodies.size()) return;
  const double least = mass_of(scene.bodies[lightest]);
  const double most = mass_of(scene.bodies[heaviest]);
  if (most <= largest_mass_ratio * least) return;
  throw SceneFault(paths[lightest], "expected masses that differ by a factor of at most " +
                                        in_digits(largest_mass_ratio) + ", found " +
                                        in_digits(least) + " kg beside " + in_digits(most) +
                                        " kg of " + paths[heaviest] +
                                        "; state a \"mass\" for one of the two");
}

}  // namespace cs550
