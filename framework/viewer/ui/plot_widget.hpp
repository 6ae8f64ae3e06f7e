#pragma once
/// @file plot_widget.hpp
/// Curves in a panel.

#include "drawing/plot.hpp"
#include "viewer/ui/theme.hpp"

namespace cs550::viewer {

/// Draws a plot in the full width of the present window. @param height pixels
void show_plot(const drawing::Plot& plot, float height, const Fonts& fonts);

}  // namespace cs550::viewer
