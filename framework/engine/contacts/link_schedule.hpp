#pragma once
/// @file link_schedule.hpp
/// The groups of contacts that are solved side by side.

#include "engine/world_state.hpp"

namespace cs550 {

/// Puts the links of a unit into groups in which no two share a movable body. Links that do keep their order.
/// Several threads may do so for units of one phase. @pre order.states has room
/// @param bodies their number
void form_groups(SolveOrder& order, SolveUnit& unit, std::size_t bodies);

}  // namespace cs550
