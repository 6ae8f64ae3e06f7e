#pragma once
/// @file colours.hpp
/// Colours with opacity for solids and the GPU, in the hues of drawing/palette.hpp.

#include "cs550/math.hpp"
#include "drawing/palette.hpp"

namespace cs550::pages {

/// Red, green, blue and opacity, each 0–1, in sRGB like drawing::Colour.
using Rgba = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;

/// A colour of the palette.
Rgba as_rgba(drawing::Colour colour, float opacity = 1);
/// The colour of a role.
Rgba role_rgba(drawing::Role role, float opacity = 1);

/// The colour of bodies that never move: light, so that shadows and other bodies stand out.
Rgba ground_colour();

/// The colour of a body: one hue per mesh, one shade per body, the same in every run.
Rgba body_colour(Index mesh, Index body);

/// A body's colour while it is asleep: dimmer.
Rgba asleep_colour(const Rgba& colour);

}  // namespace cs550::pages
