#include "cs550/rigid_body.hpp"

#include <Eigen/LU>

namespace cs550 {

RigidBody make_dynamic_body(Real mass, const Mat3& inertia, const Pose& pose) {
  RigidBody body;
  body.mass = mass;
  body.inverse_mass = 1 / mass;
  body.inertia = inertia;
  body.inverse_inertia = inertia.cast<double>().inverse().cast<Real>();
  body.pose = pose;
  return body;
}

RigidBody make_immovable_body(BodyKind kind, const Pose& pose) {
  RigidBody body;
  body.kind = kind;
  body.mass = 0;
  body.inverse_mass = 0;
  body.inertia = Mat3::Zero();
  body.inverse_inertia = Mat3::Zero();
  body.pose = pose;
  return body;
}

void set_velocity(RigidBody& body, const Vec3& linear, const Vec3& angular) {
  switch (body.kind) {
    case BodyKind::Static:
      return;
    case BodyKind::Kinematic:
      body.linear_velocity = linear;
      body.angular_velocity = angular;
      return;
    case BodyKind::Dynamic:
      body.linear_momentum = body.mass * linear;
      body.angular_momentum = body.pose.rotate(body.inertia * body.pose.unrotate(angular));
      return;
  }
}

Real kinetic_energy(const RigidBody& body) {
  if (body.kind != BodyKind::Dynamic) return 0;
  const Vec3 l = body.pose.unrotate(body.angular_momentum);
  const Vec3 w = body.inverse_inertia * l;
  const Vec3 v = body.inverse_mass * body.linear_momentum;  // the square of P may not be finite
  return (v.dot(body.linear_momentum) + w.dot(l)) / 2;
}

}  // namespace cs550
