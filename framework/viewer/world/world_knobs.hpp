#pragma once
/// @file world_knobs.hpp
/// The settings of a world, as knobs.

#include "cs550/world.hpp"
#include "viewer/knobs.hpp"

namespace cs550::viewer {

/// Visits every setting of a world.
void describe(WorldSettings& settings, KnobVisitor& visit);

}  // namespace cs550::viewer
