#pragma once
/// @file row_order.hpp
/// Which end of a row of contacts is solved first.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Turns the rows of each part so that they are solved from the middle of the world outwards.
///
/// A row is a zigzag of contacts, such as those between two courses of bricks: each shares a brick with the next one,
/// in turn an upper and a lower one. Either end may come first, but a contact waits for those of the row below on the
/// same bricks. Solved from the slope of a pyramid inwards, each row begins two contacts after the one below, since its
/// first brick rests on the first two. Solved towards the slope, it begins one or two after, and fewer lanes are empty.
/// @param order its links are sorted, and its units have their contacts
void turn_rows_outwards(std::span<const RigidBody> bodies, const BodyParts& parts,
                        SolveOrder& order);

}  // namespace cs550
