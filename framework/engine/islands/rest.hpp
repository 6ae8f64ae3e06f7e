#pragma once
/// @file rest.hpp
/// Whether a body is at rest. Reasons for the criterion are in the book's chapter on performance.

#include "engine/world_state.hpp"

namespace cs550 {

/// A body is at rest if no point of its surface moves farther than quiet_distance (length units) in
/// quiet_time (s), and if it does not speed up. The displacement is that of the whole window, so
/// neither vibration nor a moment without velocity matters.
/// @{
inline constexpr Real quiet_time = Real(0.5);
inline constexpr Real quiet_distance = Real(4e-4);
/// In the second half of a window a body may move farther than in the first half only if that is less
/// than this (length units). A body that begins to fall moves ever farther.
inline constexpr Real quiet_speeding_up = Real(1e-4);
/// @}

/// Starts a new window at the current pose. The body does not count as settled.
void restart_window(const RigidBody& body, BodyRest& rest);

/// Brings the windows of all moving bodies up to date. Call it at the end of a step.
/// @param h step (s)
void watch_rest(WorldState& world, Real h);

}  // namespace cs550
