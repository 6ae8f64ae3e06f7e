#pragma once
/// @file sleeping.hpp
/// Sleeping: an island whose bodies are all at rest is not simulated until something disturbs it. An
/// *island* is a group of dynamic bodies that are connected by contact points.
///
/// A sleeping body has no velocity, and is skipped wherever bodies move. Its pairs with other sleeping
/// bodies and with immovable ones at rest are kept in a list of their own, with their manifolds and
/// impulses, so that no later stage meets them. No pair that is solved has a sleeping body. Without
/// settings.sleeping, bodies that still sleep are woken and none is put to sleep.

#include "engine/islands/rest.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Whether bodies move alike with both settings: threads and checks do not matter.
bool move_alike(const WorldSettings& one, WorldSettings other);

/// Wakes what has been disturbed since the last step: islands with a body that was moved, pushed or
/// is subject to a force; islands on an immovable body that moves; all of them if a setting has
/// changed that decides how bodies move. Call it at the start of a step.
void wake_disturbed_bodies(WorldState& world);

/// Wakes islands that a body which is awake comes near to, and puts islands at rest to sleep. Call it
/// when the manifolds of a step are known: sleeping bodies then keep those of their own poses.
void update_sleep(WorldState& world);

/// Wakes the islands that bodies belong to or support, before they are removed.
/// @param bodies of each body, whether it is one of them
void wake_around(WorldState& world, const std::vector<char>& bodies);

}  // namespace cs550
