#pragma once
/// @file layout.hpp
/// The areas of panels and picture. The picture always has at least half of the width.

#include "pages/base/camera.hpp"

namespace cs550::viewer {

using namespace pages;

/// The parts of a window. An area without width is not shown.
struct Layout {
  Area panel;                     ///< to the left: pages, settings
  Area plots;                     ///< to the right
  Area picture;                   ///< between them
  bool plots_are_inside = false;  ///< of the panel, below the settings
};

/// The scale of text and lines in a picture, so that a larger picture only has more detail.
float picture_scale(Size picture);

/// The scale of text and widgets on panels. In a small window it shrinks, to at least three
/// quarters.
/// @param screen_scale 1 on a screen of about 100 dots per inch, more on a high-resolution one
float panel_scale(Size window, float screen_scale);

/// Panels beside the picture. If they would cover more than half of the width, the plots move into
/// the panel. If the panel alone would, it is not shown. @param scale of the panels
Layout lay_out(Size window, float scale, bool has_plots);

/// The layout without panels.
Layout picture_only(Size window);

}  // namespace cs550::viewer
