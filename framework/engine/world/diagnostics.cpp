#include "cs550/diagnostics.hpp"

namespace cs550 {

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

}  // namespace cs550
