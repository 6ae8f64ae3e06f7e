#include "cs550/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cs550 {
namespace {

/// A step squares momenta.
bool is_finite(const RigidBody& body) {
  return body.pose.position.allFinite() && body.pose.orientation.coeffs().allFinite() &&
         std::isfinite(body.linear_momentum.squaredNorm()) && body.angular_momentum.allFinite() &&
         std::isfinite(kinetic_energy(body));
}

/// The first body that is not finite; no_index if all are.
Index first_lost_body(const World& world) {
  const auto bodies = world.bodies();
  const auto lost = std::find_if(bodies.begin(), bodies.end(),
                                 [](const RigidBody& body) { return !is_finite(body); });
  return lost == bodies.end() ? no_index : static_cast<Index>(lost - bodies.begin());
}

}  // namespace

Energy energy(const World& world, Real h) {
  const Eigen::Vector3d g = world.settings().gravity.cast<double>();
  Energy sum;
  for (const RigidBody& body : world.bodies()) {
    if (body.kind != BodyKind::Dynamic) continue;
    const double m = static_cast<double>(body.mass);
    sum.kinetic += static_cast<double>(kinetic_energy(body));
    sum.potential -= m * g.dot(body.pose.position.cast<double>());
    sum.invariant += 0.5 * static_cast<double>(h) * g.dot(body.linear_momentum.cast<double>());
  }
  sum.invariant += sum.total();
  return sum;
}

Eigen::Vector3d linear_momentum(const World& world) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RigidBody& body : world.bodies()) {
    if (body.kind == BodyKind::Dynamic) sum += body.linear_momentum.cast<double>();
  }
  return sum;
}

Eigen::Vector3d angular_momentum(const World& world) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RigidBody& body : world.bodies()) {
    if (body.kind != BodyKind::Dynamic) continue;
    const Eigen::Vector3d x = body.pose.position.cast<double>();
    const Eigen::Vector3d p = body.linear_momentum.cast<double>();
    sum += body.angular_momentum.cast<double>() + x.cross(p);
  }
  return sum;
}

Velocities velocities_from_momenta(const RigidBody& body) {
  const Vec3 angular_momentum = body.pose.unrotate(body.angular_momentum);
  return {body.inverse_mass * body.linear_momentum,
          body.pose.rotate(body.inverse_inertia * angular_momentum)};
}

bool is_finite(const World& world) { return first_lost_body(world) == no_index; }

std::vector<StageProblem> find_broken_stages(World before, Real h) {
  before.settings().check_stages = true;
  before.step(h);
  std::vector<StageProblem> problems(before.problems().begin(), before.problems().end());
  if (const Index body = first_lost_body(before); problems.empty() && body != no_index) {
    const std::int64_t step = before.step_count() - 1;
    const bool energy_is_finite = std::isfinite(kinetic_energy(before.bodies()[body]));
    const char* lost = energy_is_finite ? "the square of its momentum" : "its kinetic energy";
    problems.push_back({Stage::Solve, 0, body, step,
                        "body " + std::to_string(body) + ", step " + std::to_string(step) + ": " +
                            lost + " exceeds the range of float"});
  }
  return problems;
}

}  // namespace cs550
