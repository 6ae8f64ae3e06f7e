#include "pages/base/colours.hpp"

#include <cmath>

namespace cs550::pages {
namespace {

/// A well-spread number from 0 to 1: the fractional part of a multiple of the golden ratio.
float shade_of(Index body) {
  constexpr float golden = 0.618034F;
  const float multiple = golden * static_cast<float>(body);
  return multiple - std::floor(multiple);
}

}  // namespace

Rgba as_rgba(drawing::Colour colour, float opacity) {
  constexpr float most = 255;
  return {static_cast<float>(colour.red) / most, static_cast<float>(colour.green) / most,
          static_cast<float>(colour.blue) / most, opacity};
}

Rgba role_rgba(drawing::Role role, float opacity) {
  return as_rgba(drawing::colour(role), opacity);
}

Rgba ground_colour() { return {0.93F, 0.93F, 0.92F, 1.0F}; }

Rgba body_colour(Index mesh, Index body) {
  using drawing::Colour;
  // Okabe & Ito's hues, sorted by contrast.
  constexpr Colour hues[] = {{0x00, 0x72, 0xB2}, {0xE6, 0x9F, 0x00}, {0x56, 0xB4, 0xE9},
                             {0xD5, 0x5E, 0x00}, {0x00, 0x9E, 0x73}, {0xCC, 0x79, 0xA7}};
  constexpr int hue_count = 6;
  const Rgba hue = as_rgba(hues[mesh % hue_count]);
  const float towards_white = 0.12F + 0.16F * shade_of(body);
  Rgba colour = hue + towards_white * (Rgba(1, 1, 1, 1) - hue);
  colour.w() = 1;
  return colour;
}

Rgba asleep_colour(const Rgba& colour) {
  const Rgba grey(0.62F, 0.62F, 0.62F, colour.w());
  return 0.45F * colour + 0.55F * grey;
}

}  // namespace cs550::pages
