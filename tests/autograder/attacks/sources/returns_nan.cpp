#include <limits>
#include "cs550/integration.hpp"
namespace cs550 {
namespace {
const Vec3 nan = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());
}
void add_force(RigidBody& body, const Vec3&, const Vec3&) { body.force = body.torque = nan; }
void apply_impulse(RigidBody& body, const Vec3&, const Vec3&) { body.linear_momentum = nan; }
Mat3 world_inverse_inertia(const RigidBody&) { return nan.asDiagonal(); }
void refresh_velocity(RigidBody& body) { body.linear_velocity = body.angular_velocity = nan; }
void integrate_momentum(RigidBody& body, Real) { body.linear_momentum = nan; }
void integrate_pose(RigidBody& body, Real, RotationMethod) { body.pose.position = nan; }
}  // namespace cs550
