/// @file integration.cpp
/// Lab 1: integration. The handout is README.md in this folder. The contract of each function is in
/// framework/include/cs550/integration.hpp, the body in rigid_body.hpp in the same folder.

#include "cs550/integration.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

/// Worked example: a figure skater, who rotates about one axis only. This lab does the same in
/// three dimensions.
struct Skater {
  Real inertia;           // kg·m²; smaller when she draws in her arms
  Real angular_momentum;  // kg·m²/s
  Real angle;             // rad
};

[[maybe_unused]] void glide(Skater& skater, Real torque, Real h) {
  // 1. The torque acts for a time h, so the momentum changes by τ·h. Two calls with h/2 give the
  //    same result as one with h. Without the factor h they would give twice as much.
  skater.angular_momentum += torque * h;

  // 2. The velocity is not stored but derived from the momentum. When she draws in her arms, she
  //    spins faster, without any code for that case.
  const Real angular_velocity = skater.angular_momentum / skater.inertia;

  // 3. The new velocity moves her, not the old one. This is the semi-implicit Euler method.
  skater.angle += angular_velocity * h;
}

}  // namespace

void add_force([[maybe_unused]] RigidBody& body, [[maybe_unused]] const Vec3& force,
               [[maybe_unused]] const Vec3& point) {
  // L1.1: What does a force do apart from pushing, if it acts off centre?
  throw NotImplemented("L1.1");
}

void apply_impulse([[maybe_unused]] RigidBody& body, [[maybe_unused]] const Vec3& impulse,
                   [[maybe_unused]] const Vec3& point) {
  // L1.2: No time passes during an impulse. Who reads the velocities next?
  throw NotImplemented("L1.2");
}

Mat3 world_inverse_inertia([[maybe_unused]] const RigidBody& body) {
  // L1.3: In which frame is the inverse inertia known? How does a world vector get there and back?
  throw NotImplemented("L1.3");
}

void refresh_velocity([[maybe_unused]] RigidBody& body) {
  // L1.4: Which of the three kinds of body needs a case of its own?
  throw NotImplemented("L1.4");
}

void integrate_momentum([[maybe_unused]] RigidBody& body, [[maybe_unused]] Real h) {
  // L1.5: Two steps of h/2 must give the same momentum as one step of h.
  throw NotImplemented("L1.5");
}

void integrate_pose([[maybe_unused]] RigidBody& body, [[maybe_unused]] Real h,
                    [[maybe_unused]] RotationMethod method) {
  if (method == RotationMethod::Explicit) {
    // L1.6: ω is in the world frame. On which side of q does it belong?
    throw NotImplemented("L1.6");
  }

  // L1.7: L is constant, so ω can be computed at any orientation. Write that as a helper first.
  throw NotImplemented("L1.7");
}

}  // namespace cs550
