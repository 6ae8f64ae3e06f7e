#include "engine/contacts/contact_constraints.hpp"

#include <algorithm>

#include "engine/contacts/solve_order.hpp"

namespace cs550 {

namespace {

ContactConstraint make_constraint(const Contact& contact, const ContactPoint& point, const Pose& a,
                                  const Pose& b) {
  const Manifold& manifold = contact.manifold;
  // Halfway between the surfaces: the impulses on the two bodies then have one line of action, and
  // friction conserves angular momentum too.
  const Vec3 middle = Real(0.5) * (a.to_world(point.anchor_a) + b.to_world(point.anchor_b));
  ContactConstraint constraint;
  constraint.body_a = contact.body_a;
  constraint.body_b = contact.body_b;
  constraint.n = manifold.normal;
  constraint.u = manifold.tangent;
  constraint.r_a = middle - a.position;
  constraint.r_b = middle - b.position;
  constraint.separation = point.separation;
  constraint.friction = contact.friction;
  constraint.restitution = contact.restitution;
  constraint.normal_impulse = point.normal_impulse;
  constraint.tangent_impulse = point.tangent_impulse;
  return constraint;
}

}  // namespace

Vec3 ContactConstraint::v() const { return n.cross(u); }

void ContactConstraint::mark_impact() { impact_handled = impact_handled || normal_impulse > 0; }

void make_constraints(WorldState& world) {
  arrange_constraints(world.pairs.contacts, world.bodies, world.solve_order);
  world.constraints.resize(world.solve_order.place_of_point.size());
  for_constraints_of_contacts(world, [&](const Contact& contact, std::span<const Index> places) {
    const Pose& a = world.bodies[contact.body_a].pose;
    const Pose& b = world.bodies[contact.body_b].pose;
    auto place = places.begin();
    for (const ContactPoint& point : contact.manifold.points) {
      world.constraints[*place++] = make_constraint(contact, point, a, b);
    }
  });
}

void refresh_masses(WorldState& world, const ContactStep& step) {
  // By then the inverse inertia of a needle of 1 : 50 may have grown by half across its length.
  // With twice the effective mass that a constraint has, every pass would overshoot further than
  // the last.
  constexpr Real far = Real(0.02);
  const auto has_turned = [&](const SolverBody& body) {
    return body.delta_rotation.squaredNorm() > far * far;
  };
  const std::vector<SolverBody>& bodies = world.solver_bodies;
  if (std::none_of(bodies.begin(), bodies.end(), has_turned)) return;
  for (ContactConstraint& constraint : world.constraints) {
    if (has_turned(bodies[constraint.body_a]) || has_turned(bodies[constraint.body_b])) {
      prepare_contacts({&constraint, 1}, bodies, step);
    }
  }
}

}  // namespace cs550
