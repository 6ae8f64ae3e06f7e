#include <algorithm>

#include "engine/contacts/contact_constraints.hpp"
#include "engine/world/stages.hpp"

namespace cs550 {

namespace {

/// Σ P of the dynamic bodies (N·s).
Eigen::Vector3d total_momentum(const WorldState& world) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for_dynamic_bodies(world,
                     [&](const RigidBody& body) { sum += body.linear_momentum.cast<double>(); });
  return sum;
}

/// Adds the impulse of a constraint if it comes from an immovable body.
void add_outer_impulse(const WorldState& world, const ContactConstraint& constraint,
                       Eigen::Vector3d& sum) {
  const Vec3 impulse = constraint.normal_impulse * constraint.n +
                       constraint.tangent_impulse.x() * constraint.u +
                       constraint.tangent_impulse.y() * constraint.v();
  if (world.bodies[constraint.body_a].kind != BodyKind::Dynamic) sum += impulse.cast<double>();
  if (world.bodies[constraint.body_b].kind != BodyKind::Dynamic) sum -= impulse.cast<double>();
}

/// The impulses of one substep that come from outside the dynamic bodies: forces over h, and those
/// of constraints against immovable bodies (N·s).
Eigen::Vector3d outer_impulse(const WorldState& world, Real h) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for_dynamic_bodies(world, [&](const RigidBody& body) {
    sum += static_cast<double>(h) * body.force.cast<double>();
  });
  // In the order of the contacts: that of the constraints depends on the number of threads.
  for_constraints_of_contacts(world, [&](Index, std::span<const Index> places) {
    for (const Index place : places) add_outer_impulse(world, world.constraints[place], sum);
  });
  return sum;
}

}  // namespace

void begin_audit(WorldState& world) {
  if (!world.settings.audit_momentum) return;
  world.audit_before = world.audit;
  world.audit.unexplained -= total_momentum(world);
}

void audit_substep(WorldState& world, Real h) {
  if (!world.settings.audit_momentum) return;
  read_back_impulses(world);
  world.audit.unexplained -= outer_impulse(world, h);
}

void end_audit(WorldState& world, Real h) {
  if (!world.settings.audit_momentum) return;
  world.audit.unexplained += total_momentum(world);
  // The scale of the error: the momenta, and for bodies at rest the weight that acts during a step.
  double sum = 0;
  for_dynamic_bodies(world, [&](const RigidBody& body) {
    sum += static_cast<double>(body.linear_momentum.norm());
    sum += static_cast<double>(body.mass * world.settings.gravity.norm() * h);
  });
  world.audit.largest_sum = std::max(world.audit.largest_sum, sum);
}

}  // namespace cs550
