#include "engine/world/world_state.hpp"

namespace cs550 {

Eigen::Vector3d total_momentum(const WorldState& world) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RigidBody& body : world.bodies) {
    if (body.kind == BodyKind::Dynamic) sum += body.linear_momentum.cast<double>();
  }
  return sum;
}

Eigen::Vector3d outer_impulse(const WorldState& world, Real h) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RigidBody& body : world.bodies) {
    if (body.kind == BodyKind::Dynamic) sum += static_cast<double>(h) * body.force.cast<double>();
  }
  const auto is_dynamic = [&](Index body) {
    return world.bodies[static_cast<std::size_t>(body)].kind == BodyKind::Dynamic;
  };
  for (const ContactConstraint& constraint : world.constraints) {
    const Vec3 impulse = constraint.normal_impulse * constraint.n +
                         constraint.tangent_impulse.x() * constraint.u +
                         constraint.tangent_impulse.y() * constraint.v();
    if (!is_dynamic(constraint.body_a)) sum += impulse.cast<double>();
    if (!is_dynamic(constraint.body_b)) sum -= impulse.cast<double>();
  }
  return sum;
}

}  // namespace cs550
