#pragma once
/// @file theme.hpp
/// Colours and fonts of the panels.

#include <imgui/imgui.h>

namespace cs550::viewer {

/// A font with a size.
struct Typeface {
  ImFont* font = nullptr;
  float size = 0;  ///< pixels
};

/// The fonts of the panels. The built-in font of Dear ImGui is used if none is installed.
struct Fonts {
  Typeface text;    ///< panels
  Typeface title;   ///< headings
  Typeface small;   ///< axes of plots, labels in the picture
  float scale = 1;  ///< of the fonts, and of lines and gaps beside text
};

/// Sets colours, sizes and fonts of the present Dear ImGui context. @param scale 1 on a screen of
/// about 100 dots per inch, more on a high-resolution one
Fonts apply_theme(float scale);

/// Colours that our own widgets share with those of Dear ImGui.
/// @{
inline constexpr ImU32 ink = IM_COL32(27, 30, 35, 255);
inline constexpr ImU32 quiet_ink = IM_COL32(96, 102, 112, 255);
inline constexpr ImU32 hairline = IM_COL32(200, 204, 210, 255);
inline constexpr ImU32 paper = IM_COL32(255, 255, 255, 255);
inline constexpr ImU32 halo = IM_COL32(255, 255, 255, 210);
inline constexpr ImU32 warning_ink = IM_COL32(178, 70, 0, 255);
/// @}

}  // namespace cs550::viewer
