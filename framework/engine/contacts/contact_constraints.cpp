#include "engine/contacts/contact_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "engine/contacts/solve_order.hpp"

namespace cs550 {

namespace {

/// About the ratio of the smallest to the largest radius of gyration: 1/3 for a cube, 0.02 for a
/// needle of 1 : 50. A needle that turns by its thinness moves its ends by its own thickness: the
/// lever of a contact there about the needle's axis, and with it the effective mass, is another one.
Real thinness(const RigidBody& body) {
  if (body.kind != BodyKind::Dynamic) return 1;
  return 1 / std::sqrt(body.inertia.trace() * body.inverse_inertia.trace());
}

/// Thicker bodies are not thin: the masses of their contacts change little with the levers.
constexpr Real thin = Real(0.1);

/// The point where the impulses of a contact act on both bodies, so that they have one line of action
/// and friction conserves angular momentum too.
///
/// It is halfway between the surfaces. But about the axis of a needle, half a gap or half a penetration
/// is a lever many times the needle's thickness: the point is then on the surface of the thinner body.
Vec3 acting_point(const RigidBody& a, const RigidBody& b, const Vec3& on_a, const Vec3& on_b) {
  const Real thinness_a = thinness(a);
  const Real thinness_b = thinness(b);
  if (std::min(thinness_a, thinness_b) >= thin) return Real(0.5) * (on_a + on_b);
  return thinness_a < thinness_b ? on_a : on_b;
}

ContactConstraint make_constraint(const Contact& contact, const ContactPoint& point,
                                  const RigidBody& a, const RigidBody& b) {
  const Manifold& manifold = contact.manifold;
  const Vec3 acting =
      acting_point(a, b, a.pose.to_world(point.anchor_a), b.pose.to_world(point.anchor_b));
  ContactConstraint constraint;
  constraint.body_a = contact.body_a;
  constraint.body_b = contact.body_b;
  constraint.n = manifold.normal;
  constraint.u = manifold.tangent;
  constraint.r_a = acting - a.pose.position;
  constraint.r_b = acting - b.pose.position;
  constraint.separation = point.separation;
  constraint.friction = contact.friction;
  constraint.restitution = contact.restitution;
  constraint.normal_impulse = point.normal_impulse;
  constraint.tangent_impulse = point.tangent_impulse;
  return constraint;
}

/// Turns the levers with the bodies. The separation is such that, with what the bodies have moved, it
/// is the distance of the two anchors now.
void move_levers(WorldState& world, const Contact& contact, std::span<const Index> places) {
  const RigidBody& a = world.bodies[contact.body_a];
  const RigidBody& b = world.bodies[contact.body_b];
  const SolverBody& solver_a = world.solver_bodies[contact.body_a];
  const SolverBody& solver_b = world.solver_bodies[contact.body_b];
  auto place = places.begin();
  for (const ContactPoint& point : contact.manifold.points) {
    ContactConstraint& constraint = world.constraints[*place++];
    const Vec3 on_a = a.pose.to_world(point.anchor_a);
    const Vec3 on_b = b.pose.to_world(point.anchor_b);
    const Vec3 acting = acting_point(a, b, on_a, on_b);
    constraint.r_a = acting - a.pose.position;
    constraint.r_b = acting - b.pose.position;
    const Vec3 moved = solver_b.delta_position + solver_b.delta_rotation.cross(constraint.r_b) -
                       solver_a.delta_position - solver_a.delta_rotation.cross(constraint.r_a);
    constraint.separation = constraint.n.dot(on_b - on_a - moved);
  }
}

void prepare_again(WorldState& world, const ContactStep& step, std::span<const Index> places) {
  for (const Index place : places) {
    prepare_contacts({&world.constraints[place], 1}, world.solver_bodies, step);
  }
}

}  // namespace

Vec3 ContactConstraint::v() const { return n.cross(u); }

void ContactConstraint::mark_impact() { impact_handled = impact_handled || normal_impulse > 0; }

void make_constraints(WorldState& world) {
  arrange_constraints(world.pairs.contacts, world.bodies, world.solve_order);
  world.constraints.resize(world.solve_order.place_of_point.size());
  for_constraints_of_contacts(world, [&](const Contact& contact, std::span<const Index> places) {
    const RigidBody& a = world.bodies[contact.body_a];
    const RigidBody& b = world.bodies[contact.body_b];
    auto place = places.begin();
    for (const ContactPoint& point : contact.manifold.points) {
      world.constraints[*place++] = make_constraint(contact, point, a, b);
    }
  });
}

void refresh_masses(WorldState& world, const ContactStep& step) {
  constexpr Real far = Real(0.02);
  const auto turn = [&](Index i) { return world.solver_bodies[i].delta_rotation.norm(); };
  const auto has_turned_far = [&](Index i) { return turn(i) > far; };
  const auto has_turned_its_thinness = [&](Index i) {
    const Real limit = thinness(world.bodies[i]);
    return limit < thin && turn(i) > limit;
  };
  for_constraints_of_contacts(world, [&](const Contact& contact, std::span<const Index> places) {
    const bool levers =
        has_turned_its_thinness(contact.body_a) || has_turned_its_thinness(contact.body_b);
    if (!levers && !has_turned_far(contact.body_a) && !has_turned_far(contact.body_b)) return;
    const double before = impulse_energy(world, places);
    if (levers) move_levers(world, contact, places);
    prepare_again(world, step, places);
    limit_impulse_energy(world, step, places, before);
  });
}

void refresh_masses_of_thin_bodies(WorldState& world, const ContactStep& step) {
  const auto turns_far = [&](Index i) {
    const RigidBody& body = world.bodies[i];
    return step.h * body.angular_velocity.norm() > thinness(body) / 2;
  };
  for_constraints_of_contacts(world, [&](const Contact& contact, std::span<const Index> places) {
    if (turns_far(contact.body_a) || turns_far(contact.body_b)) prepare_again(world, step, places);
  });
}

}  // namespace cs550
