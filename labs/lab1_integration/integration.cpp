// Lab 1: integration. The handout is README.md in this folder; what each function promises is in
// framework/include/cs550/integration.hpp, and the body itself in rigid_body.hpp beside it.

#include "cs550/integration.hpp"

#include "cs550/not_implemented.hpp"

namespace cs550 {
namespace {

// A worked example, complete: a figure skater, who turns about one axis only. The same three
// thoughts, in three dimensions, are this lab.

struct Skater {
  Real inertia;           // kg·m²; smaller when she draws in her arms
  Real angular_momentum;  // kg·m²/s
  Real angle;             // rad
};

[[maybe_unused]] void glide(Skater& skater, Real torque, Real h) {
  // 1. The torque acts for a time h, so the momentum changes by τ·h. Halve h and call twice: the
  //    result is the same. Without the h it would double.
  skater.angular_momentum += torque * h;

  // 2. The velocity is not stored, it is derived from the momentum when it is needed. She draws in
  //    her arms, and turns faster, without a line of code that says so.
  const Real angular_velocity = skater.angular_momentum / skater.inertia;

  // 3. The new velocity moves her, not the old one: the semi-implicit Euler method.
  skater.angle += angular_velocity * h;
}

}  // namespace

void add_force([[maybe_unused]] RigidBody& body, [[maybe_unused]] const Vec3& force,
               [[maybe_unused]] const Vec3& point) {
  // L1.1, step 1: gather the force in the body. The mass has no part in this.
  // L1.1, step 2: gather its torque about the centre of mass. Which way round is the cross product?
  // See README.md, L1.1.
  throw NotImplemented("L1.1");
}

void apply_impulse([[maybe_unused]] RigidBody& body, [[maybe_unused]] const Vec3& impulse,
                   [[maybe_unused]] const Vec3& point) {
  // L1.2, step 1: leave the bodies alone that nothing can push.
  // L1.2, step 2: change both momenta at once. No time passes in an impulse.
  // L1.2, step 3: whoever reads the velocities next must see the change.
  // See README.md, L1.2.
  throw NotImplemented("L1.2");
}

Mat3 world_inverse_inertia([[maybe_unused]] const RigidBody& body) {
  // L1.3, step 1: take the rotation matrix of the pose.
  // L1.3, step 2: read from right to left what happens to a world vector: into the body's frame,
  //               through the inverse inertia there, and back.
  // See README.md, L1.3.
  throw NotImplemented("L1.3");
}

void refresh_velocity([[maybe_unused]] RigidBody& body) {
  // L1.4, step 1: store the inverse inertia in the world frame, for every kind of body.
  // L1.4, step 2: a kinematic body's velocities are its owner's: not derived, not touched.
  // L1.4, step 3: derive both velocities from the momenta. What do the inverses of a static body
  //               make of them?
  // See README.md, L1.4.
  throw NotImplemented("L1.4");
}

void integrate_momentum([[maybe_unused]] RigidBody& body, [[maybe_unused]] Real h) {
  // L1.5, step 1: only a dynamic body has momenta to change.
  // L1.5, step 2: let the gathered force and torque act for a time h.
  // L1.5, step 3: there is none: force and torque stay for the next substep.
  // See README.md, L1.5.
  throw NotImplemented("L1.5");
}

void integrate_pose([[maybe_unused]] RigidBody& body, [[maybe_unused]] Real h,
                    [[maybe_unused]] RotationMethod method) {
  // Both methods, step 1: a static body stays where it is.
  // Both methods, step 2: carry the position along with the velocity.

  if (method == RotationMethod::Explicit) {
    // L1.6, step 3: write ω as a quaternion without a real part, and multiply: on which side of q
    //               does a world-frame ω stand?
    // L1.6, step 4: add the rate of change, times h, to the four coefficients.
    // L1.6, step 5: the sum is too long. Make it unit length again.
    // See README.md, L1.6.
    throw NotImplemented("L1.6");
  }

  // L1.7, step 3: write a helper that gives ω at *any* orientation q, from L, which is constant.
  // L1.7, step 4: guess w, turn half a step by it, and ask your helper for a better w: three times.
  //               rotation_exp() in math.hpp makes the quaternion of a turn.
  // L1.7, step 5: turn the whole step by the last w. Does a kinematic body need steps 3 and 4?
  // See README.md, L1.7.
  throw NotImplemented("L1.7");
}

}  // namespace cs550
