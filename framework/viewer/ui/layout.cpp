#include "viewer/ui/layout.hpp"

#include <algorithm>
#include <cmath>

namespace cs550::viewer {
namespace {

constexpr Size usual = {1280, 720};       ///< a window in which everything has its full size
constexpr float panel_width = 330;        ///< pixels at scale 1
constexpr float plots_width = 300;        ///< pixels at scale 1
constexpr float least_shrinking = 0.75F;  ///< smaller text is hard to read
constexpr float shrinking_step = 0.05F;   ///< every change of the scale rebuilds the fonts
constexpr float most_for_panels = 0.5F;   ///< share of the width

float share_of_usual(Size size) {
  return std::min(static_cast<float>(size.width) / static_cast<float>(usual.width),
                  static_cast<float>(size.height) / static_cast<float>(usual.height));
}

}  // namespace

float picture_scale(Size picture) { return std::max(1.0F, share_of_usual(picture)); }

float panel_scale(Size window, float screen_scale) {
  const float share = share_of_usual(window) / screen_scale;
  const float stepped = shrinking_step * std::floor(share / shrinking_step + 1e-3F);
  return screen_scale * std::clamp(stepped, least_shrinking, 1.0F);
}

Layout lay_out(Size window, float scale, bool has_plots) {
  Layout layout = picture_only(window);
  const float room = most_for_panels * layout.picture.width;
  const float panel = panel_width * scale;
  const float plots = plots_width * scale;
  if (panel > room) return layout;
  layout.panel = {0, 0, panel, layout.picture.height};
  layout.picture.left += panel;
  layout.picture.width -= panel;
  if (!has_plots) return layout;
  if (panel + plots > room) {
    layout.plots_are_inside = true;
    return layout;
  }
  layout.picture.width -= plots;
  layout.plots = {layout.picture.left + layout.picture.width, 0, plots, layout.picture.height};
  return layout;
}

Layout picture_only(Size window) {
  Layout layout;
  layout.picture = {0, 0, static_cast<float>(window.width), static_cast<float>(window.height)};
  return layout;
}

}  // namespace cs550::viewer
