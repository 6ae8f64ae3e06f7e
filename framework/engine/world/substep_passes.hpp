#pragma once
/// @file substep_passes.hpp
/// The passes of a substep that the settings of a world ask for.

#include "engine/contacts/contact_passes.hpp"
#include "engine/world_state.hpp"

namespace cs550 {

/// Whether contacts are springs with dampers.
bool is_soft(const WorldSettings& settings);

/// Whether the impulses of the last step are applied first.
bool starts_warm(const WorldSettings& settings);

/// Whether contacts resist rolling.
bool resists_rolling(const WorldSettings& settings);

/// Lets the contacts of a unit of the solve order resist the rotation of their bodies relative to each
/// other, as settings.rolling_resistance specifies. @pre resists_rolling()
void resist_rolling(WorldState& world, std::size_t unit);

/// Whether a contact is about to bounce.
bool any_impact(const WorldState& world, const ContactStep& step);

/// The passes with bias, without their warm start.
Passes biased_passes(const WorldState& world, const ContactStep& step);

/// The passes after the bodies have moved. @pre world.impacts.any is that of this substep
Passes relax_passes(const WorldState& world);

}  // namespace cs550
