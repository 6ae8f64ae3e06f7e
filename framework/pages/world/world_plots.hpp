#pragma once
/// @file world_plots.hpp
/// What happened in a world, over time.

#include <deque>
#include <vector>

#include "drawing/plot.hpp"
#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// Energy, momentum, penetration, contacts and, if wished, the time that each stage took.
std::vector<drawing::Plot> world_plots(const std::deque<StepSample>& history, bool with_times);

}  // namespace cs550::pages
