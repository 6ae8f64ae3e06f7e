/// @file warm_starting.cpp
/// Warm starting: the impulses of the last step are the first guess of this one. They are stored in
/// the contact points and carried from the old manifold to the new one.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/contacts/contact_constraints.hpp"

namespace cs550 {
namespace {

/// For each new point the old point whose impulse it takes over; no_index if there is none.
using Matches = StaticVector<Index, max_manifold_points>;

bool is_taken(const Matches& matches, Index old) {
  return std::find(matches.begin(), matches.end(), old) != matches.end();
}

Matches match_features(const Manifold& before, const Manifold& now) {
  Matches matches;
  for (const ContactPoint& point : now.points) {
    const auto* same =
        std::find_if(before.points.begin(), before.points.end(),
                     [&](const ContactPoint& old) { return old.feature == point.feature; });
    const bool found = same != before.points.end();
    matches.push_back(found ? static_cast<Index>(same - before.points.begin()) : no_index);
  }
  return matches;
}

/// The old point nearest to a new one, in A's frame, among those that are not taken.
Index nearest_free(const Manifold& before, const Matches& matches, const ContactPoint& point) {
  Index nearest = no_index;
  Real smallest = HUGE_VALF;
  for (Index i = 0; i < before.points.size(); ++i) {
    const Real distance = (before.points[i].anchor_a - point.anchor_a).squaredNorm();
    if (distance < smallest && !is_taken(matches, i)) {
      smallest = distance;
      nearest = i;
    }
  }
  return nearest;
}

/// A corner that slides over an edge gets a new feature id. If its impulse were lost, the load
/// would be dropped for a step, and a stack of boxes standing edge on edge would shake.
Matches match_points(const Manifold& before, const Manifold& now) {
  Matches matches = match_features(before, now);
  for (Index i = 0; i < now.points.size(); ++i) {
    if (matches[i] == no_index) matches[i] = nearest_free(before, matches, now.points[i]);
  }
  return matches;
}

/// v of the frame (n, u, v).
Vec3 second_tangent(const Manifold& manifold) { return manifold.normal.cross(manifold.tangent); }

/// @param worth factor of what the impulses' energy may be from now on
void scale_impulses(PairList& pairs, std::size_t pair, Real factor, double worth) {
  for (ContactPoint& point : pairs.contacts[pair].manifold.points) {
    point.normal_impulse *= factor;
    point.tangent_impulse *= factor;
  }
  pairs.impulse_energy[pair] *= worth;
}

/// What a load's impulse grows by. Beyond the range of Real the next step begins without impulses, like the first one.
Real growth(Real before, Real now) {
  const Real factor = now / before;
  return std::isfinite(factor) ? factor : 0;
}

double squared(Real factor) { return static_cast<double>(factor) * static_cast<double>(factor); }

}  // namespace

void carry_impulses(const Manifold& before, Manifold& now) {
  const Real turned = before.normal.dot(now.normal);
  const Vec3 v_before = second_tangent(before);
  const Vec3 v_now = second_tangent(now);
  const Matches matches = match_points(before, now);
  for (Index i = 0; i < now.points.size(); ++i) {
    if (matches[i] == no_index) continue;
    const ContactPoint& last = before.points[matches[i]];
    ContactPoint& point = now.points[i];
    point.normal_impulse = std::max(Real(0), last.normal_impulse * turned);
    const Vec3 impulse =
        last.tangent_impulse.x() * before.tangent + last.tangent_impulse.y() * v_before;
    point.tangent_impulse = {impulse.dot(now.tangent), impulse.dot(v_now)};
  }
}

void fit_impulses(WorldState& world, Real h) {
  const Real before = std::exchange(world.substep_length, h);
  if (before == h || before == 0) return;
  const Real factor = growth(before, h);
  // Impulses that carry weight grow with the substep, but those of a blow do not: their energy may not grow.
  const double worth = std::min(1.0, squared(factor));
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    scale_impulses(world.pairs, i, factor, worth);
  }
}

void fit_loads(PairList& pairs, const std::vector<char>& chosen, Real before, Real now) {
  if (before == now) return;
  const Real factor = growth(before, now);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (chosen[i]) scale_impulses(pairs, i, factor, squared(factor));
  }
}

void store_impulses(WorldState& world) {
  std::fill(world.pairs.impulse_energy.begin(), world.pairs.impulse_energy.end(), 0.0);
  world.touches.assign(world.pairs.size(), 0);
  for_constraints_of_contacts_in_blocks(world, [&](Index contact, std::span<const Index> places) {
    auto place = places.begin();
    for (ContactPoint& point : world.pairs.contacts[contact].manifold.points) {
      const ContactConstraint& constraint = world.constraints[*place++];
      point.normal_impulse = constraint.normal_impulse;
      point.tangent_impulse = constraint.tangent_impulse;
    }
    world.pairs.impulse_energy[contact] = impulse_energy(world, places);
    world.touches[contact] = static_cast<char>(is_touching(world, contact, places));
  });
}

}  // namespace cs550
