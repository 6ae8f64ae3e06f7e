#pragma once
/// @file svg_parts.hpp
/// The parts of a page, each drawn into its own area.

#include "drawing/svg.hpp"
#include "drawing/svg_writer.hpp"

namespace cs550::drawing {

/// Letters of labels and axes (pixels).
inline constexpr double small_text = 12;
/// From one line of small text to the next (pixels).
inline constexpr double line_height = 17;

/// Draws elements that are finite.
/// @param keep_in_view what the view must show, where it has no frame of its own
void draw_scene(SvgWriter& svg, const Drawing& drawing, const View& view,
                std::span<const Vec3> keep_in_view, const Rectangle& area);

/// Draws axes, series and marks, without title and legend.
void draw_plot(SvgWriter& svg, const Plot& plot, const Rectangle& area);

/// The legend of a plot.
std::vector<LegendEntry> legend_of(const Plot& plot);

}  // namespace cs550::drawing
