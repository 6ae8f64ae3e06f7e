#pragma once
/// @file query_prefetch.hpp
/// Fetches into the cache what queries are about to read. Where each of many bodies has a shape of its own, a query waits
/// for memory at every link from the pair over a body and its shape to a face. The links of several pairs are therefore
/// followed side by side.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// A pair for which labs 3 to 5 have to answer.
struct PairQuery {
  Index pair;
  Real margin;  ///< see contact_margin() (m)
};

/// Whether the meshes of the world are too large for the cache. In a small world, or in one whose bodies share a shape,
/// prefetching costs more than it saves.
bool pays_to_prefetch(const WorldState& world);

/// @param queries that come next, a few of them
void prefetch_meshes(const WorldState& world, std::span<const PairQuery> queries);

}  // namespace cs550
