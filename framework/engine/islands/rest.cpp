#include "engine/islands/rest.hpp"

#include "engine/pairs/displacement.hpp"

namespace cs550 {

namespace {

/// Ends a window in which the body stayed near its start, and begins the next one.
void end_window(const RigidBody& body, BodyRest& rest, Real radius, Real unit) {
  const Real second_half = largest_displacement(rest.middle, body.pose, radius);
  const bool quiet = second_half <= std::max(rest.first_half, quiet_speeding_up * unit);
  restart_window(body, rest);
  rest.settled = quiet;
}

void watch(const RigidBody& body, BodyRest& rest, Real radius, Real unit, Real h) {
  const Real displacement = largest_displacement(rest.start, body.pose, radius);
  if (!(displacement <= quiet_distance * unit)) return restart_window(body, rest);

  const bool was_in_first_half = rest.time < quiet_time / 2;
  rest.time += h;
  if (was_in_first_half && rest.time >= quiet_time / 2) {
    rest.middle = body.pose;
    rest.first_half = displacement;
  }
  if (rest.time >= quiet_time) end_window(body, rest, radius, unit);
}

}  // namespace

void restart_window(const RigidBody& body, BodyRest& rest) {
  rest.start = body.pose;
  rest.middle = body.pose;
  rest.first_half = 0;
  rest.time = 0;
  rest.settled = false;
}

void watch_rest(WorldState& world, Real h) {
  if (!world.settings.sleeping) return;
  const Real unit = world.settings.length_unit;
  for (std::size_t i = 0; i < world.slot_count(); ++i) {
    const RigidBody& body = world.bodies[i];
    if (!world.slots[i].alive || body.kind != BodyKind::Dynamic || body.asleep) continue;
    BodyRest& rest = world.sleeping.bodies[i];
    if (world.unwritten.any()) {
      restart_window(body, rest);  // a body that no code moves is not at rest
    } else {
      watch(body, rest, world.definitions[i].shape->radius, unit, h);
    }
    world.sleeping.left[i] = {body.pose, body.linear_momentum, body.angular_momentum};
  }
}

}  // namespace cs550
