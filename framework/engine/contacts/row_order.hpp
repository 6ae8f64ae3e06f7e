#pragma once
/// @file row_order.hpp
/// Which end of a row of contacts is solved first.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Finds the rows of each part. A world of one part has none.
///
/// A row is a zigzag of at least three contacts that carry weight, such as those between two courses of bricks: each
/// shares a brick with the next one, in turn an upper and a lower one. It may be solved from either end, but a contact
/// waits for those below on the same bricks. Solved from the slope of a pyramid inwards, each row begins two contacts
/// after the one below, since the brick at its end waits for the first two of these. Solved towards the slope, it
/// begins one or two after, and fewer lanes are empty.
/// @param parts of the bodies
/// @param order its links are sorted, and its units know their contacts
void find_rows(const BodyParts& parts, SolveOrder& order);

/// Turns the rows so that they are solved from the middle of the world outwards. One across that direction lies as
/// its links were sorted.
/// @param bodies of the world
/// @param parts of the bodies
/// @returns whether a row was turned
bool turn_rows_outwards(std::span<const RigidBody> bodies, const BodyParts& parts,
                        SolveOrder& order);

}  // namespace cs550
