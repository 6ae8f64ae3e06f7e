#include "viewer/palette.hpp"

#include "viewer/render/ink_renderer.hpp"

namespace cs550::viewer {
namespace {

/// A number from 0 to 1 that looks random: the fractional parts of multiples of the golden ratio.
float shade_of(Index body) {
  constexpr float golden = 0.618034F;
  const float multiple = golden * static_cast<float>(body);
  return multiple - std::floor(multiple);
}

}  // namespace

Rgba ground_colour() { return {0.93F, 0.93F, 0.92F, 1.0F}; }

Rgba body_colour(Index mesh, Index body) {
  using drawing::Colour;
  // Okabe & Ito's hues, the most different ones first.
  constexpr Colour hues[] = {{0x00, 0x72, 0xB2}, {0xE6, 0x9F, 0x00}, {0x56, 0xB4, 0xE9},
                             {0xD5, 0x5E, 0x00}, {0x00, 0x9E, 0x73}, {0xCC, 0x79, 0xA7}};
  constexpr int hue_count = 6;
  const Rgba hue = as_colour(hues[mesh % hue_count]);
  const float towards_white = 0.12F + 0.16F * shade_of(body);
  Rgba colour = hue + towards_white * (Rgba(1, 1, 1, 1) - hue);
  colour.w() = 1;
  return colour;
}

}  // namespace cs550::viewer
