#include "engine/contacts/contact_constraints.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "engine/contacts/contact_passes.hpp"
#include "engine/contacts/solve_order.hpp"
#include "engine/parts/body_parts.hpp"

namespace cs550 {

namespace {

BodySize size_of(const RigidBody& body) {
  if (body.kind != BodyKind::Dynamic) return {};
  const Real inertia = body.inertia.trace();
  return {inertia * body.inverse_inertia.trace(), 4 * body.inverse_mass * inertia};
}

/// Measures the bodies, and forgets the displacements of the last step.
void begin_substeps(WorldState& world) {
  world.sizes.resize(world.bodies.size());
  world.solver_bodies.resize(world.bodies.size());
  for_body_blocks(world, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      world.sizes[i] = size_of(world.bodies[i]);
      world.solver_bodies[i] = {};
    }
  });
}

/// Thicker bodies are not slender: the masses of their contacts change little with the levers.
constexpr Real slender = 100;

/// How far a body has turned since the step began.
TurnSize turn_size(const SolverBody& solver_body, Real squared_slenderness) {
  constexpr Real far = Real(0.02);
  const Real squared_turn = solver_body.delta_rotation.squaredNorm();
  if (squared_slenderness > slender && squared_turn * squared_slenderness > 1) {
    return TurnSize::PastThinness;
  }
  return squared_turn > far * far ? TurnSize::Far : TurnSize::Small;
}

/// How far a body turns within a substep, if that is far for its thinness.
TurnSize turn_size_in_substep(const RigidBody& body, Real squared_slenderness, Real h) {
  const Real squared_turn = h * h * body.angular_velocity.squaredNorm();
  return squared_turn * squared_slenderness > Real(0.25) ? TurnSize::PastThinness : TurnSize::Small;
}

bool any_turned(std::span<const TurnSize> turns) {
  return std::any_of(turns.begin(), turns.end(),
                     [](TurnSize turn) { return turn != TurnSize::Small; });
}

/// Of the two bodies of a contact.
TurnSize larger_turn(const WorldState& world, const std::vector<TurnSize>& turns,
                     std::span<const Index> places) {
  const ContactConstraint& first = world.constraints[places[0]];
  return std::max(turns[first.body_a], turns[first.body_b]);
}

/// From the centres of mass to the points where the impulses of a contact act.
struct Levers {
  Vec3 r_a, r_b;
};

/// The bodies of a contact, as the arrays of a substep number them.
std::pair<Index, Index> bodies_of(const WorldState& world, const Contact& contact) {
  return {world.parts.number_of(contact.body_a), world.parts.number_of(contact.body_b)};
}

/// Where the impulses of a contact act. On both bodies at the same point, so that they have one line of
/// action and friction conserves angular momentum too.
///
/// It is halfway between the surfaces. But about the axis of a needle, half a gap or half a penetration
/// is a lever many times the needle's thickness: the point is then on the surface of the thinner body.
///
/// Bodies that move by more than their length in a step have contacts across gaps of that size, or have left
/// each other since. Halfway is then outside of both. Impulses act where the bodies touch once the gap is
/// closed: on the surface of each.
class ActingPoint {
 public:
  /// @param body_a, body_b as the constraints number them
  ActingPoint(const WorldState& world, Index body_a, Index body_b)
      : centre_a_(world.bodies[body_a].pose.position),
        centre_b_(world.bodies[body_b].pose.position) {
    const BodySize& a = world.sizes[body_a];
    const BodySize& b = world.sizes[body_b];
    squared_reach_ = std::min(a.squared_length, b.squared_length);
    if (std::max(a.squared_slenderness, b.squared_slenderness) <= slender) return;
    share_of_a_ = a.squared_slenderness > b.squared_slenderness ? Real(1) : Real(0);
  }

  Levers between(const Vec3& on_a, const Vec3& on_b) const {
    if ((on_b - on_a).squaredNorm() > squared_reach_) return {on_a - centre_a_, on_b - centre_b_};
    const Vec3 acting = common_point(on_a, on_b);
    return {acting - centre_a_, acting - centre_b_};
  }

 private:
  Vec3 common_point(const Vec3& on_a, const Vec3& on_b) const {
    if (share_of_a_ == Real(0.5)) return Real(0.5) * (on_a + on_b);
    return share_of_a_ == 1 ? on_a : on_b;
  }

  Vec3 centre_a_, centre_b_;
  Real squared_reach_ = 0;
  Real share_of_a_ = Real(0.5);
};

/// All but the bodies.
ContactConstraint make_constraint(const Contact& contact, const ContactPoint& point,
                                  const Levers& levers) {
  const Manifold& manifold = contact.manifold;
  ContactConstraint constraint;
  constraint.n = manifold.normal;
  constraint.u = manifold.tangent;
  constraint.r_a = levers.r_a;
  constraint.r_b = levers.r_b;
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
  const auto [body_a, body_b] = bodies_of(world, contact);
  const RigidBody& a = world.bodies[body_a];
  const RigidBody& b = world.bodies[body_b];
  const SolverBody& solver_a = world.solver_bodies[body_a];
  const SolverBody& solver_b = world.solver_bodies[body_b];
  const ActingPoint acting_point(world, body_a, body_b);
  auto place = places.begin();
  for (const ContactPoint& point : contact.manifold.points) {
    ContactConstraint& constraint = world.constraints[*place++];
    const Vec3 on_a = a.pose.to_world(point.anchor_a);
    const Vec3 on_b = b.pose.to_world(point.anchor_b);
    const Levers levers = acting_point.between(on_a, on_b);
    constraint.r_a = levers.r_a;
    constraint.r_b = levers.r_b;
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

/// Calls `refresh(contact, places, turn)` for the contacts whose bodies have turned.
template <class Refresh>
void for_turned_contacts(WorldState& world, const std::vector<TurnSize>& turns,
                         const Refresh& refresh) {
  if (!any_turned(turns)) return;
  read_back_impulses(world);
  std::atomic<bool> any = false;
  for_constraints_of_contacts_in_blocks(world, [&](Index contact, std::span<const Index> places) {
    const TurnSize turn = larger_turn(world, turns, places);
    if (turn == TurnSize::Small) return;
    refresh(contact, places, turn);
    any.store(true, std::memory_order_relaxed);
  });
  if (any) world.mirrors.set_stale_numbers();
}

/// The turns of the bodies in the contacts of a unit, without immovable bodies, which do not turn.
std::span<const TurnSize> turns_for_unit(const WorldState& world, std::span<const TurnSize> turns,
                                         std::size_t unit) {
  const BodyParts& parts = world.parts;
  if (unit >= static_cast<std::size_t>(parts.count)) return turns;
  const auto first = static_cast<std::size_t>(parts.first[unit]);
  return turns.subspan(first, static_cast<std::size_t>(parts.first[unit + 1]) - first);
}

/// The same for the contacts of one unit.
template <class Refresh>
void for_turned_contacts_of_unit(WorldState& world, const std::vector<TurnSize>& turns,
                                 std::size_t unit, const Refresh& refresh) {
  if (!any_turned(turns_for_unit(world, turns, unit))) return;
  read_back_impulses(world, unit);
  const SolveOrder& order = world.solve_order;
  const SolveUnit& solved = order.units[unit];
  for (Index i = solved.first_contact; i < solved.end_contact; ++i) {
    const Index contact = order.contacts[i];
    const std::span<const Index> places = order.places_of(contact);
    const TurnSize turn = larger_turn(world, turns, places);
    if (turn == TurnSize::Small) continue;
    refresh(contact, places, turn);
    world.mirrors.of_units[unit].stale_numbers = true;
  }
}

/// Gives a contact masses that suit the present poses.
auto refreshing(WorldState& world, const ContactStep& step) {
  return [&](Index contact, std::span<const Index> places, TurnSize turn) {
    const double before = impulse_energy(world, places);
    if (turn == TurnSize::PastThinness) move_levers(world, world.pairs.contacts[contact], places);
    prepare_again(world, step, places);
    limit_impulse_energy(world, step, places, before);
  };
}

auto preparing_again(WorldState& world, const ContactStep& step) {
  return
      [&](Index, std::span<const Index> places, TurnSize) { prepare_again(world, step, places); };
}

}  // namespace

Vec3 ContactConstraint::v() const { return n.cross(u); }

void ContactConstraint::mark_impact() { impact_handled = impact_handled || normal_impulse > 0; }

void read_back_impulses(WorldState& world, std::size_t unit) {
  ConstraintMirror& mirror = world.mirrors.of_units[unit];
  if (!mirror.is_ahead) return;
  // No passes: this only copies impulses and marks from the mirror, whose layout run_passes() alone knows.
  run_passes(mirror, constraints_of(world, world.solve_order.units[unit]), world.solver_bodies, {},
             {.store = true});
}

void read_back_impulses(WorldState& world) {
  const std::vector<ConstraintMirror>& mirrors = world.mirrors.of_units;
  if (std::none_of(mirrors.begin(), mirrors.end(),
                   [](const ConstraintMirror& mirror) { return mirror.is_ahead; }))
    return;
  for_units(world.team, world.solve_order,
            [&](std::size_t unit) { read_back_impulses(world, unit); });
}

void arrange_contacts(WorldState& world) {
  BodyParts& parts = world.parts;
  const Vec3& gravity = world.settings.gravity;
  divide_bodies(world.pairs, world.bodies, gravity, parts, world.team);
  ThreadTeam* const team = passes_spare_immovable_bodies() ? world.team : nullptr;
  arrange_constraints(world.pairs, world.bodies, gravity, world.solve_order, parts, team);
  const std::vector<Index>& contacts = world.solve_order.contacts;
  world.any_bounces = std::any_of(contacts.begin(), contacts.end(), [&](Index contact) {
    return world.pairs.summaries[contact].bounces;
  });
}

void begin_constraints(WorldState& world) {
  begin_substeps(world);
  world.constraints.resize(world.solve_order.place_of_point.size());
  world.mirrors.set_stale();
}

void make_constraints(WorldState& world, Index index) {
  const Contact& contact = world.pairs.contacts[index];
  const auto [body_a, body_b] = bodies_of(world, contact);
  const Pose& a = world.bodies[body_a].pose;
  const Pose& b = world.bodies[body_b].pose;
  const ActingPoint acting_point(world, body_a, body_b);
  auto place = world.solve_order.places_of(index).begin();
  for (const ContactPoint& point : contact.manifold.points) {
    const Levers levers =
        acting_point.between(a.to_world(point.anchor_a), b.to_world(point.anchor_b));
    ContactConstraint& constraint = world.constraints[*place++];
    constraint = make_constraint(contact, point, levers);
    constraint.body_a = body_a;
    constraint.body_b = body_b;
  }
}

void make_constraints(WorldState& world) {
  for_constraints_of_contacts_in_blocks(
      world, [&](Index contact, std::span<const Index>) { make_constraints(world, contact); });
}

void forget_turns(WorldState& world) {
  world.turns.assign(world.bodies.size(), TurnSize::Small);
  world.turns_in_substep.assign(world.bodies.size(), TurnSize::Small);
}

void measure_turns(WorldState& world, std::size_t first, std::size_t last, Real h) {
  for (std::size_t i = first; i < last; ++i) {
    if (world.bodies[i].kind == BodyKind::Static) continue;  // other threads may read its turn
    const Real squared_slenderness = world.sizes[i].squared_slenderness;
    world.turns[i] = turn_size(world.solver_bodies[i], squared_slenderness);
    world.turns_in_substep[i] = turn_size_in_substep(world.bodies[i], squared_slenderness, h);
  }
}

void refresh_masses(WorldState& world, const ContactStep& step) {
  for_turned_contacts(world, world.turns, refreshing(world, step));
}

void refresh_masses(WorldState& world, const ContactStep& step, std::size_t unit) {
  for_turned_contacts_of_unit(world, world.turns, unit, refreshing(world, step));
}

void refresh_masses_of_thin_bodies(WorldState& world, const ContactStep& step) {
  for_turned_contacts(world, world.turns_in_substep, preparing_again(world, step));
}

void refresh_masses_of_thin_bodies(WorldState& world, const ContactStep& step, std::size_t unit) {
  for_turned_contacts_of_unit(world, world.turns_in_substep, unit, preparing_again(world, step));
}

}  // namespace cs550
