#pragma once
/// @file body_parts.hpp
/// The parts of a world that several threads solve at the same time.
///
/// A contact is inside a part or between two. Threads first solve what is inside, each in its own parts, and
/// then what is between. The order of the contacts follows from that (solve_order.hpp), so a world has its
/// parts with one thread, too.

#include <span>

#include "engine/world_state.hpp"

namespace cs550 {

/// Divides the bodies into parts that lie side by side across gravity and have about as many contacts each.
/// Cuts are straight, and where few contacts cross them. A world with few contacts is one part.
/// Call it once per step: bodies keep their parts for some steps. A body that is added meanwhile is in the first part,
/// or in that of the removed body whose index it takes over.
/// @param gravity in the world frame
/// @param team that shares the work, if there is one
void divide_bodies(const PairList& pairs, std::span<const RigidBody> bodies, const Vec3& gravity,
                   BodyParts& parts, ThreadTeam* team = nullptr);

}  // namespace cs550
