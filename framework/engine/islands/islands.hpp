#pragma once
/// @file islands.hpp
/// The islands of a world: groups of dynamic bodies connected by contact points, found by union-find.
/// Immovable bodies do not connect.

#include "engine/world_state.hpp"

namespace cs550 {

/// Finds the islands that may be put to sleep: all bodies are settled (see rest.hpp), no immovable body
/// that they touch moves, and they are supported. What floats freely is at rest only without any
/// momentum. Bodies that the program pushes are not settled.
///
/// The result is sleeping.island_of: for each body of such an island its smallest index, for all other
/// bodies no_index.
/// @returns whether there is one
bool find_resting_islands(WorldState& world);

}  // namespace cs550
