#pragma once
/// @file imgui_calls.hpp
/// Colours for Dear ImGui, and calls whose names or arguments differ between its versions (1.86 to
/// 1.92).

#include <imgui/imgui.h>

#include <span>

#include "drawing/palette.hpp"
#include "viewer/ui/theme.hpp"

namespace cs550::viewer {

inline void push_font(const Typeface& face) {
#if IMGUI_VERSION_NUM >= 19200
  ImGui::PushFont(face.font, face.size);
#else
  ImGui::PushFont(face.font);
#endif
}

inline void add_outline(ImDrawList* list, ImVec2 upper, ImVec2 lower, ImU32 colour, float rounding,
                        float thickness) {
#if IMGUI_VERSION_NUM >= 19280
  list->AddRect(upper, lower, colour, rounding, thickness);
#else
  list->AddRect(upper, lower, colour, rounding, 0, thickness);
#endif
}

inline void add_polyline(ImDrawList* list, std::span<const ImVec2> points, ImU32 colour,
                         float thickness) {
  const int count = static_cast<int>(points.size());
#if IMGUI_VERSION_NUM >= 19280
  list->AddPolyline(points.data(), count, colour, thickness);
#else
  list->AddPolyline(points.data(), count, colour, 0, thickness);
#endif
}

inline ImU32 packed(drawing::Colour colour, int opacity = 255) {
  return IM_COL32(colour.red, colour.green, colour.blue, opacity);
}

}  // namespace cs550::viewer
