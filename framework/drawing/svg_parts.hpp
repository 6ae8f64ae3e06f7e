#pragma once
/// @file svg_parts.hpp
/// The parts of a page. Each is drawn into its own area.

#include "drawing/svg.hpp"
#include "drawing/svg_writer.hpp"

namespace cs550::drawing {

/// Font size of labels and axes (pixels).
inline constexpr double small_text = 12;
/// Line spacing of small text (pixels).
inline constexpr double line_height = 17;

/// Draws a scene. @pre its elements are finite
/// @param keep_in_view positions that must be visible, unless the view has a frame
void draw_scene(SvgWriter& svg, const Drawing& drawing, const View& view,
                std::span<const Vec3> keep_in_view, const Rectangle& area);

/// Draws axes, series and marks, without title and legend.
void draw_plot(SvgWriter& svg, const Plot& plot, const Rectangle& area);

/// The legend of a plot.
std::vector<LegendEntry> legend_of(const Plot& plot);

}  // namespace cs550::drawing
