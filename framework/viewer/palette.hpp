#pragma once
/// @file palette.hpp
/// Colours of shaded bodies, in the hues of drawing/palette.hpp.

#include "viewer/gl/shader.hpp"

namespace cs550::viewer {

/// Of what never moves: light, so that shadows and bodies stand out.
Rgba ground_colour();

/// Of a body: a hue for each mesh, a shade for each body. Both are the same in every run.
Rgba body_colour(Index mesh, Index body);

}  // namespace cs550::viewer
