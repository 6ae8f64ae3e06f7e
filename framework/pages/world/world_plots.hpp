#pragma once
/// @file world_plots.hpp
/// The history of a world as plots.

#include <deque>
#include <vector>

#include "drawing/plot.hpp"
#include "pages/world/world_frame.hpp"

namespace cs550::pages {

/// Energy, momentum, penetration, contacts and, optionally, the time of each stage.
std::vector<drawing::Plot> world_plots(const std::deque<StepSample>& history, bool with_times);

}  // namespace cs550::pages
