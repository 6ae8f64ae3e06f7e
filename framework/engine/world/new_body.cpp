#include "engine/world/new_body.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace cs550 {

namespace {

void require_of_body(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("a body needs ") + what);
}

/// The square of a larger one may not be finite.
constexpr Real largest_friction = Real(1e6);

/// Whether squares of a velocity are finite, also times the radius of a body.
bool is_bounded(const Vec3& velocity) { return velocity.norm() <= Real(1e18); }

void check_definition(const BodyDef& def) {
  require_of_body(def.shape != nullptr, "a shape");
  require_of_body(def.pose.position.allFinite(), "a finite position");
  require_of_body(std::abs(def.pose.orientation.norm() - 1) < Real(1e-3),
                  "a unit quaternion as its orientation");
  require_of_body(is_bounded(def.linear_velocity) && is_bounded(def.angular_velocity),
                  "finite velocities, each of at most 1e18");
  if (def.mass) {
    require_of_body(std::isfinite(*def.mass) && *def.mass > 0, "a positive, finite mass");
  }
  require_of_body(std::isfinite(def.density) && def.density > 0, "a positive, finite density");
  require_of_body(def.friction >= 0 && def.friction <= largest_friction,
                  "a friction from 0 to 1e6");
  require_of_body(def.restitution >= 0 && def.restitution <= 1, "a restitution from 0 to 1");
}

/// Whether the moments of inertia and their reciprocals are within the range of Real.
bool can_turn(const RigidBody& body) {
  return body.inertia.allFinite() && body.inverse_inertia.allFinite() &&
         (body.inverse_inertia.diagonal().array() > 0).all();
}

/// A step squares momenta and impulses, at speeds of up to 10 km/s.
constexpr Real largest_mass = Real(1e15);
/// Of a body at its farthest point to an impulse there (1/kg). A step multiplies two such numbers.
constexpr Real largest_response = Real(1e18);

/// The largest possible one.
Real response(const RigidBody& body, Real radius) {
  return body.inverse_mass + radius * radius * body.inverse_inertia.diagonal().maxCoeff();
}

void check_range(const RigidBody& body, Real radius) {
  require_of_body(can_turn(body),
                  "a mass with which its moments of inertia and their reciprocals are finite");
  require_of_body(body.mass <= largest_mass, "a mass of at most 1e15 kg");
  require_of_body(
      response(body, radius) <= largest_response,
      "a mass with which 1/mass + radius²/(smallest moment of inertia) is at most 1e18/kg");
  require_of_body(
      std::isfinite(kinetic_energy(body)) && std::isfinite(body.linear_momentum.squaredNorm()),
      "velocities with which its kinetic energy and the square of its momentum are finite");
}

/// Beyond rounding, so that a pose that another body has is taken as it is.
Pose with_unit_orientation(Pose pose) {
  if (std::abs(pose.orientation.norm() - 1) > Real(1e-6)) pose.orientation.normalize();
  return pose;
}

}  // namespace

RigidBody make_body(const BodyDef& def) {
  check_definition(def);
  const Pose pose = with_unit_orientation(def.pose);
  RigidBody body;
  if (def.kind == BodyKind::Dynamic) {
    const Real density = def.mass ? *def.mass / def.shape->volume : def.density;
    const Real mass = def.mass ? *def.mass : density * def.shape->volume;  // exactly what it says
    body = make_dynamic_body(mass, density * def.shape->unit_inertia, pose);
  } else {
    body = make_immovable_body(def.kind, pose);
  }
  set_velocity(body, def.linear_velocity, def.angular_velocity);
  if (def.kind == BodyKind::Dynamic) check_range(body, def.shape->radius);
  return body;
}

}  // namespace cs550
