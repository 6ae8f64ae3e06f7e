#include <limits>
#include "cs550/integration.hpp"
namespace cs550 {
namespace {
const Vec3 endless = Vec3::Constant(std::numeric_limits<Real>::infinity());
}
void add_force(RigidBody& body, const Vec3&, const Vec3&) { body.force = endless; }
void apply_impulse(RigidBody& body, const Vec3&, const Vec3&) { body.linear_momentum = endless; }
Mat3 world_inverse_inertia(const RigidBody&) { return endless.asDiagonal(); }
void refresh_velocity(RigidBody& body) { body.linear_velocity = endless; }
void integrate_momentum(RigidBody& body, Real) { body.linear_momentum = endless; }
void integrate_pose(RigidBody& body, Real, RotationMethod) { body.pose.position = endless; }
}  // namespace cs550
