#include <algorithm>

#include "engine/world/world_state.hpp"

namespace cs550 {

namespace {

ContactConstraint make_constraint(const Contact& contact, const ContactPoint& point, const Pose& a,
                                  const Pose& b) {
  const Manifold& manifold = contact.manifold;
  // Halfway between the surfaces: both bodies then feel the impulse on one line of action, and
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

void SolverBody::apply(const Vec3& impulse, const Vec3& r) {
  v += inverse_mass * impulse;
  w += world_inverse_inertia * r.cross(impulse);
}

void make_constraints(WorldState& world) {
  arrange_constraints(world.pairs.contacts, world.bodies, world.solve_order);
  world.constraints.resize(world.solve_order.place_of_point.size());
  for_constraints_of_contacts(world, [&](Contact& contact, std::span<const Index> places) {
    const Pose& a = world.bodies[static_cast<std::size_t>(contact.body_a)].pose;
    const Pose& b = world.bodies[static_cast<std::size_t>(contact.body_b)].pose;
    auto place = places.begin();
    for (const ContactPoint& point : contact.manifold.points) {
      world.constraints[static_cast<std::size_t>(*place++)] = make_constraint(contact, point, a, b);
    }
  });
}

void refresh_masses(WorldState& world, const ContactStep& step) {
  // By then the inverse inertia of a needle of 1 : 50 may have grown by half across its length; with
  // twice the mass that a constraint believes in, every pass would overshoot further than the last.
  constexpr Real far = Real(0.02);
  const auto has_turned = [&](const SolverBody& body) {
    return body.delta_rotation.squaredNorm() > far * far;
  };
  if (std::none_of(world.velocities.begin(), world.velocities.end(), has_turned)) return;
  for (ContactConstraint& constraint : world.constraints) {
    if (has_turned(world.velocities[static_cast<std::size_t>(constraint.body_a)]) ||
        has_turned(world.velocities[static_cast<std::size_t>(constraint.body_b)])) {
      prepare_contacts({&constraint, 1}, world.velocities, step);
    }
  }
}

void store_impulses(WorldState& world) {
  auto touched = world.pairs.touching.begin();
  for_constraints_of_contacts(world, [&](Contact& contact, std::span<const Index> places) {
    char touching = 0;
    auto place = places.begin();
    for (ContactPoint& point : contact.manifold.points) {
      const ContactConstraint& constraint = world.constraints[static_cast<std::size_t>(*place++)];
      point.normal_impulse = constraint.normal_impulse;
      point.tangent_impulse = constraint.tangent_impulse;
      if (constraint.impact_handled || point.separation <= 0) touching = 1;
    }
    const ContactEvent event{world.id_at(contact.body_a), world.id_at(contact.body_b)};
    if (touching && !*touched) world.began.push_back(event);
    if (!touching && *touched) world.ended.push_back(event);
    *touched++ = touching;
  });
}

void gather_solver_bodies(const WorldState& world, std::span<SolverBody> velocities) {
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const RigidBody& body = world.bodies[i];
    velocities[i].v = body.linear_velocity;
    velocities[i].w = body.angular_velocity;
    velocities[i].inverse_mass = body.inverse_mass;
    velocities[i].world_inverse_inertia = body.world_inverse_inertia;
  }
}

void write_back_momenta(WorldState& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    RigidBody& body = world.bodies[i];
    if (body.kind != BodyKind::Dynamic) continue;
    const Vec3 dv = world.velocities[i].v - body.linear_velocity;
    const Vec3 dw = world.velocities[i].w - body.angular_velocity;
    if (dv.isZero(0) && dw.isZero(0)) continue;
    const Vec3 dw_body = body.pose.unrotate(dw);
    body.linear_momentum += body.mass * dv;
    body.angular_momentum += body.pose.rotate(body.inertia * dw_body);
    refresh_velocity(body);
  }
}

}  // namespace cs550
