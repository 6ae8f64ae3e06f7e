#pragma once
/// @file layout.hpp
/// Where panels and picture are, so that the picture always has at least half of the room.

#include "pages/base/camera.hpp"

namespace cs550::viewer {

using namespace pages;

/// Parts of a window; an area without width is not shown.
struct Layout {
  Area panel;                     ///< to the left: pages, settings
  Area plots;                     ///< to the right
  Area picture;                   ///< between them
  bool plots_are_inside = false;  ///< of the panel, below the settings
};

/// How large things are in a picture that is seen as a whole: a larger one is the same, but finer.
float picture_scale(Size picture);

/// How large things on panels are. In a small window they shrink, to three quarters at most.
/// @param screen_scale 1 on a screen of about 100 dots per inch, more on a finer one
float panel_scale(Size window, float screen_scale);

/// Panels beside the picture. Where they would cover more than half, the plots move into the panel;
/// where the panel alone would, there is none. @param scale of the panels
Layout lay_out(Size window, float scale, bool has_plots);

/// No panels.
Layout picture_only(Size window);

}  // namespace cs550::viewer
