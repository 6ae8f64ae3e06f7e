#pragma once
/// @file captions.hpp
/// Text in the picture: labels, legend, notes.

#include "drawing/drawing.hpp"
#include "pages/base/camera.hpp"
#include "viewer/ui/theme.hpp"

namespace cs550::viewer {

using namespace pages;

/// Writes the labels of the points in the area, with a light rim. Labels without room are left
/// out. @return their number
int show_labels(const drawing::Drawing& drawing, const Projection& projection, const Area& area,
                const Fonts& fonts);

/// Writes legend and notes into the lower left corner of an area.
/// @param missing_labels the number of labels left out
void show_legend(const drawing::Drawing& drawing, const Area& area, const Fonts& fonts,
                 int missing_labels);

/// Writes a sentence into the middle of an area, in place of a picture.
void show_problem(const std::string& problem, const Area& area, const Fonts& fonts);

}  // namespace cs550::viewer
