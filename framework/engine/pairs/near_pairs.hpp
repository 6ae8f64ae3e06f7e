#pragma once
/// @file near_pairs.hpp
/// Keeps the tree and the list of near pairs up to date with the bodies.

#include "engine/world_state.hpp"

namespace cs550 {

/// The largest speed at which two surfaces may close at the bodies' current velocities (m/s).
/// @pre update_pairs() has measured the speeds of this step
Real closing_speed(const WorldState& world, Index body_a, Index body_b);

/// The margin within which two surfaces get contact points during a step of length h (m): the
/// distance that they may close at their current speeds and in free fall, and a few slops.
/// @pre update_pairs() has measured the speeds of this step
Real contact_margin(const WorldState& world, Index body_a, Index body_b, Real h);

/// The part of the margin that no motion of this step explains (m).
Real spare_margin(const WorldState& world);

/// Inserts the leaf of a new body into the tree.
void insert_leaf(WorldState& world, Index body);
/// Enlarges leaves to their bodies' current bounds, so that queries between steps find them.
void enclose_bodies(WorldState& world);
/// Brings the tree and the pairs up to date with poses and speeds. @param h step (s)
void update_pairs(WorldState& world, Real h);
/// Drops the pairs of bodies that are being removed; those that touched go to ended_by_removal.
/// @param bodies of each body, whether it is one of them
void remove_pairs_of(WorldState& world, const std::vector<char>& bodies);

}  // namespace cs550
