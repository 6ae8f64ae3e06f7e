/// @file rolling_resistance.cpp
/// Real contacts are small patches, which resist rolling and spinning. Contacts of ideal bodies are
/// points. A hull that touches its neighbours with two corners swings about the line through them
/// for minutes: the impulses at the two corners have no lever about that line.

#include "engine/contacts/rolling_resistance.hpp"

#include <algorithm>

namespace cs550 {

namespace {

Real load(std::span<const ContactConstraint> constraints, std::span<const Index> places) {
  Real sum = 0;
  for (const Index place : places) sum += constraints[place].normal_impulse;
  return sum;
}

/// Slows the rotation of two bodies relative to each other, like friction: the angular impulse
/// opposes it, is at most `limit` (N·m·s), and never reverses it. So it only takes energy.
void slow_rotation(SolverBody& a, SolverBody& b, Real limit) {
  const Vec3 relative = b.w - a.w;
  const Real speed = relative.norm();
  if (speed == 0) return;
  const Vec3 axis = relative / speed;
  const Vec3 response_a = a.world_inverse_inertia * axis;
  const Vec3 response_b = b.world_inverse_inertia * axis;
  const Real response = axis.dot(response_a + response_b);
  if (response <= 0) return;
  const Real impulse = std::min(limit, speed / response);
  a.w += impulse * response_a;
  b.w -= impulse * response_b;
}

}  // namespace

[[gnu::weak]] void resist_rolling(ConstraintMirror& /*mirror*/, const SolveOrder& order,
                                  std::span<const ContactConstraint> constraints,
                                  std::span<SolverBody> bodies, Real lever) {
  for (const Index contact : order.contacts) {
    const std::span<const Index> places = order.places_of(contact);
    const ContactConstraint& first = constraints[places[0]];
    slow_rotation(bodies[first.body_a], bodies[first.body_b], lever * load(constraints, places));
  }
}

}  // namespace cs550
