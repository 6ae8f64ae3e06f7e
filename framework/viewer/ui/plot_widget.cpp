#include "viewer/ui/plot_widget.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viewer/ui/imgui_calls.hpp"
#include "viewer/ui/plot_axes.hpp"

namespace cs550::viewer {
namespace {

using drawing::Plot;
using drawing::Series;
using drawing::SeriesStyle;

void draw_grid(ImDrawList* list, const Axis& x, const Axis& y, const Fonts& fonts) {
  const float size = fonts.small.size;
  for (const double tick : y_ticks(y)) {
    const float at =
        std::floor(y.start +
                   static_cast<float>((tick - y.lower) / (y.upper - y.lower)) * (y.end - y.start)) +
        0.5F;
    list->AddLine({x.start, at}, {x.end, at}, hairline);
    const std::string text = tick_text(y.logarithmic ? std::pow(10.0, tick) : tick);
    const float width = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
    list->AddText(fonts.small.font, size, {x.start - width - 6 * fonts.scale, at - size * 0.55F},
                  quiet_ink, text.c_str());
  }
  for (const double tick : x_ticks(x)) {
    const std::string text = tick_text(tick);
    const float width = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
    const float at =
        std::clamp(x.pixel(tick) - width / 2, x.start - 8 * fonts.scale, x.end - width);
    list->AddText(fonts.small.font, size, {at, y.start + 3 * fonts.scale}, quiet_ink, text.c_str());
  }
}

constexpr float curve_width = 1.8F;  ///< pixels at scale 1
constexpr float dot_radius = 2.6F;   ///< pixels at scale 1

/// A dashed line. `travelled` is the distance from the start of the curve (pixels).
void draw_dashes(ImDrawList* list, ImVec2 from, ImVec2 to, ImU32 colour, float scale,
                 float& travelled) {
  const float period = 9 * scale;
  const float dash = 5.5F * scale;
  const float width = curve_width * scale;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const auto at = [&](float pixels) {
    const float share = length > 0 ? pixels / length : 0;
    return ImVec2(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
  };
  for (float place = 0; place < length;) {
    const float phase = std::fmod(travelled + place, period);
    const float next = std::min(length, place + (phase < dash ? dash : period) - phase + 0.01F);
    if (phase < dash) list->AddLine(at(place), at(next), colour, width);
    place = next;
  }
  travelled += length;
}

void draw_curve(ImDrawList* list, const Series& series, const Axis& x, const Axis& y, float scale) {
  const ImU32 colour = packed(drawing::colour(series.role));
  std::vector<ImVec2> run;
  float travelled = 0;
  const auto finish = [&] {
    if (run.size() == 1) list->AddCircleFilled(run[0], dot_radius * scale, colour);
    if (!series.dashed && run.size() > 1) {
      add_polyline(list, run, colour, curve_width * scale);
    }
    for (std::size_t i = 1; series.dashed && i < run.size(); ++i) {
      draw_dashes(list, run[i - 1], run[i], colour, scale, travelled);
    }
    run.clear();
  };
  for (const Vec2& value : series.values) {
    if (!y.can_show(static_cast<double>(value.y()))) {
      finish();
      continue;
    }
    run.push_back(
        {x.pixel(static_cast<double>(value.x())), y.pixel(static_cast<double>(value.y()))});
  }
  finish();
}

void draw_series(ImDrawList* list, const Series& series, const Axis& x, const Axis& y,
                 float scale) {
  if (series.style == SeriesStyle::Curve) {
    draw_curve(list, series, x, y, scale);
    return;
  }
  for (const Vec2& value : series.values) {
    if (!y.can_show(static_cast<double>(value.y()))) continue;
    const ImVec2 at(x.pixel(static_cast<double>(value.x())),
                    y.pixel(static_cast<double>(value.y())));
    list->AddCircleFilled(at, dot_radius * scale, packed(drawing::colour(series.role)));
  }
}

void draw_marks(ImDrawList* list, const Plot& plot, const Axis& x, const Axis& y,
                const Fonts& fonts) {
  const float size = fonts.small.size;
  for (const drawing::PlotMark& mark : plot.marks) {
    const auto value = static_cast<double>(mark.at);
    const ImU32 colour = packed(drawing::colour(mark.role));
    if (mark.vertical) {
      const float at = x.pixel(value);
      list->AddLine({at, y.start}, {at, y.end}, colour, 1.5F * fonts.scale);
      list->AddText(fonts.small.font, size, {at + 4 * fonts.scale, y.end + fonts.scale}, quiet_ink,
                    mark.text.c_str());
    } else if (y.can_show(value)) {
      const float at = y.pixel(value);
      list->AddLine({x.start, at}, {x.end, at}, colour, 1.5F * fonts.scale);
      const float width = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, mark.text.c_str()).x;
      list->AddText(fonts.small.font, size,
                    {x.end - width - 2 * fonts.scale, at - size - 2 * fonts.scale}, quiet_ink,
                    mark.text.c_str());
    }
  }
}

/// The title on the left, and the legend to its right or, if there is no room, below.
/// @return height in pixels
float draw_heading(ImDrawList* list, const Plot& plot, ImVec2 at, float width, const Fonts& fonts) {
  const float text = fonts.text.size;
  const float size = fonts.small.size;
  const float scale = fonts.scale;
  list->AddText(fonts.text.font, text, at, ink, plot.title.c_str());
  ImVec2 place(at.x, at.y + text + 5 * scale);
  if (!plot.y_label.empty()) {
    const float used =
        fonts.text.font->CalcTextSizeA(text, FLT_MAX, 0, plot.title.c_str()).x + 8 * scale;
    const float label = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, plot.y_label.c_str()).x;
    const bool fits = used + label <= width;
    const ImVec2 corner = fits ? ImVec2(at.x + used, at.y + (text - size)) : place;
    list->AddText(fonts.small.font, size, corner, quiet_ink, plot.y_label.c_str());
    if (!fits) place.y += size + 3 * scale;
  }
  const auto named = std::count_if(plot.series.begin(), plot.series.end(),
                                   [](const Series& series) { return !series.name.empty(); });
  if (named < 2) return place.y - at.y + 2 * scale;
  for (const Series& series : plot.series) {
    if (series.name.empty()) continue;
    const float name = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, series.name.c_str()).x;
    const float mark = 16 * scale;
    if (place.x > at.x && place.x + mark + name > at.x + width) {
      place = {at.x, place.y + size + 3 * scale};
    }
    const float middle = place.y + size * 0.55F;
    const ImU32 colour = packed(drawing::colour(series.role));
    list->AddLine({place.x, middle}, {place.x + (series.dashed ? 4 : 11) * scale, middle}, colour,
                  3 * scale);
    if (series.dashed)
      list->AddLine({place.x + 7 * scale, middle}, {place.x + 11 * scale, middle}, colour,
                    3 * scale);
    list->AddText(fonts.small.font, size, {place.x + mark, place.y}, quiet_ink,
                  series.name.c_str());
    place.x += mark + name + 12 * scale;
  }
  return place.y + size + 6 * scale - at.y;
}

}  // namespace

void show_plot(const Plot& plot, float height, const Fonts& fonts) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float size = fonts.small.size;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float heading = draw_heading(list, plot, corner, width, fonts);
  const float label = plot.x_label.empty() ? 0 : size + 2 * fonts.scale;

  const float left = size * 3.4F;
  const float below = size + 4 * fonts.scale + label;
  const Area area{corner.x + left, corner.y + heading, width - 2 - left, height - below - heading};
  const auto [x, y] = axes_of(plot, area, size + 4 * fonts.scale);
  list->AddRectFilled({x.start, y.end}, {x.end, y.start}, paper, 3);
  draw_grid(list, x, y, fonts);
  list->PushClipRect({x.start - 1, y.end - 1}, {x.end + 1, y.start + 1}, true);
  for (const Series& series : plot.series) draw_series(list, series, x, y, fonts.scale);
  draw_marks(list, plot, x, y, fonts);
  list->PopClipRect();
  if (!plot.x_label.empty()) {
    const float text = fonts.small.font->CalcTextSizeA(size, FLT_MAX, 0, plot.x_label.c_str()).x;
    list->AddText(fonts.small.font, size,
                  {(x.start + x.end - text) / 2, y.start + size + 3 * fonts.scale}, quiet_ink,
                  plot.x_label.c_str());
  }
  ImGui::Dummy({width, height});
  for (const std::string& note : notes_of(plot)) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = fonts.small.font->CalcTextSizeA(size, FLT_MAX, width, note.c_str());
    list->AddText(fonts.small.font, size, at, quiet_ink, note.c_str(), nullptr, width);
    ImGui::Dummy({width, room.y + size / 2});
  }
}

}  // namespace cs550::viewer
