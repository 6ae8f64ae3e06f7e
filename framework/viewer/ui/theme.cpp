#include "viewer/ui/theme.hpp"

#include <filesystem>

namespace cs550::viewer {
namespace {

/// The paths of DejaVu Sans in common distributions. It has the symbols of the formulas.
const char* find_font(bool bold) {
  static constexpr const char* plain_places[] = {
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"};
  static constexpr const char* bold_places[] = {
      "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf",
      "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"};
  for (const char* place : bold ? bold_places : plain_places) {
    if (std::filesystem::exists(place)) return place;
  }
  return nullptr;
}

Typeface load_font(bool bold, float pixels) {
  // Latin, Greek, punctuation, super- and subscripts, letterlike signs, arrows, mathematics.
  static constexpr ImWchar ranges[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x1D00,
                                       0x1DBF, 0x2010, 0x209F, 0x2100, 0x214F,
                                       0x2190, 0x22FF, 0x25A0, 0x25FF, 0};
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  if (const char* file = find_font(bold)) {
    return {atlas->AddFontFromFileTTF(file, pixels, nullptr, ranges), pixels};
  }
  ImFontConfig config;
  config.SizePixels = pixels;
  return {atlas->AddFontDefault(&config), pixels};
}

void set_colours(ImVec4* colours) {
  const auto set = [&](int which, int red, int green, int blue, int alpha = 255) {
    colours[which] = ImColor(red, green, blue, alpha);
  };
  set(ImGuiCol_Text, 27, 30, 35);
  set(ImGuiCol_TextDisabled, 110, 116, 126);
  set(ImGuiCol_WindowBg, 250, 251, 252);
  set(ImGuiCol_ChildBg, 250, 251, 252, 0);
  set(ImGuiCol_PopupBg, 255, 255, 255);
  set(ImGuiCol_Border, 208, 212, 218);
  set(ImGuiCol_FrameBg, 232, 236, 241);
  set(ImGuiCol_FrameBgHovered, 218, 226, 236);
  set(ImGuiCol_FrameBgActive, 204, 216, 230);
  set(ImGuiCol_CheckMark, 0, 96, 160);
  set(ImGuiCol_SliderGrab, 86, 148, 196);
  set(ImGuiCol_SliderGrabActive, 0, 114, 178);
  set(ImGuiCol_Button, 226, 232, 240);
  set(ImGuiCol_ButtonHovered, 205, 219, 233);
  set(ImGuiCol_ButtonActive, 180, 202, 224);
  set(ImGuiCol_Header, 226, 232, 240);
  set(ImGuiCol_HeaderHovered, 212, 223, 235);
  set(ImGuiCol_HeaderActive, 196, 212, 229);
  set(ImGuiCol_Separator, 214, 218, 224);
  set(ImGuiCol_ScrollbarBg, 0, 0, 0, 0);
  set(ImGuiCol_ScrollbarGrab, 205, 210, 217);
  set(ImGuiCol_ScrollbarGrabHovered, 180, 187, 196);
  set(ImGuiCol_ScrollbarGrabActive, 150, 158, 170);
  set(ImGuiCol_TextSelectedBg, 170, 205, 235);
}

}  // namespace

Fonts apply_theme(float scale) {
  constexpr float text_pixels = 15;
  constexpr float title_pixels = 18;
  constexpr float small_pixels = 12.5F;
  ImGuiStyle style;
  set_colours(style.Colors);
  style.WindowRounding = 0;
  style.WindowBorderSize = 0;
  style.WindowPadding = {14, 12};
  style.FrameRounding = 4;
  style.FramePadding = {7, 3};
  style.GrabRounding = 4;
  style.PopupRounding = 4;
  style.ScrollbarRounding = 6;
  style.ScrollbarSize = 10;
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {7, 4};
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;

  Fonts fonts;
  fonts.scale = scale;
  fonts.text = load_font(false, text_pixels * scale);
  fonts.title = load_font(true, title_pixels * scale);
  fonts.small = load_font(false, small_pixels * scale);
  return fonts;
}

}  // namespace cs550::viewer
