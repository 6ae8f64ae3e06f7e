#include "cs550/integration.hpp"
namespace cs550 {
namespace {
const Vec3 tiny = Vec3::Constant(1e-42F);
}
void add_force(RigidBody& body, const Vec3&, const Vec3&) { body.force = body.torque = tiny; }
void apply_impulse(RigidBody& body, const Vec3&, const Vec3&) { body.linear_momentum = tiny; }
Mat3 world_inverse_inertia(const RigidBody&) { return tiny.asDiagonal(); }
void refresh_velocity(RigidBody& body) { body.linear_velocity = body.angular_velocity = tiny; }
void integrate_momentum(RigidBody& body, Real) { body.linear_momentum = tiny; }
void integrate_pose(RigidBody& body, Real, RotationMethod) { body.pose.position = tiny; }
}  // namespace cs550
