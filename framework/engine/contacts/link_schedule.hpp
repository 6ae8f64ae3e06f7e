#pragma once
/// @file link_schedule.hpp
/// The groups of contacts that are solved side by side.

#include "engine/world_state.hpp"

namespace cs550 {

/// Puts the links of a unit into groups in which no two share a movable body. Links that do keep their order.
/// @pre order.states and order.next_of_body have room; several threads may do so for units of one phase
void form_groups(SolveOrder& order, SolveUnit& unit);

}  // namespace cs550
