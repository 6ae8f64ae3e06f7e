#pragma once
/// @file world_controls.hpp
/// The settings of a world, as controls.

#include "cs550/world.hpp"
#include "pages/base/controls.hpp"

namespace cs550::pages {

/// Visits every setting of a world.
void describe(WorldSettings& settings, ControlVisitor& visit);

}  // namespace cs550::pages
