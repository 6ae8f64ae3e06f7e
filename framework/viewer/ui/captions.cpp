#include "viewer/ui/captions.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "viewer/ui/imgui_calls.hpp"

namespace cs550::viewer {
namespace {

using drawing::LegendEntry;

/// The colour, darkened enough for text on a light background.
drawing::Colour readable(drawing::Role role) {
  constexpr drawing::Colour black = {0, 0, 0};
  if (role == drawing::Role::Text || role == drawing::Role::Axis) return drawing::colour(role);
  return drawing::mix(drawing::colour(role), black, drawing::needs_outline(role) ? 0.7 : 0.35);
}

/// Small text with a light rim. @param wrap width of a line (pixels); 0: a single line
void haloed_text(ImDrawList* list, const Fonts& fonts, ImVec2 at, ImU32 colour, const char* text,
                 float wrap = 0) {
  const auto& [font, size] = fonts.small;
  const float rim = 1.3F * fonts.scale;
  for (const float x : {-rim, 0.0F, rim}) {
    for (const float y : {-rim, 0.0F, rim}) {
      if (x == 0 && y == 0) continue;
      list->AddText(font, size, {at.x + x, at.y + y}, halo, text, nullptr, wrap);
    }
  }
  list->AddText(font, size, at, colour, text, nullptr, wrap);
}

void draw_sample(ImDrawList* list, const LegendEntry& entry, ImVec2 at, float length,
                 const Fonts& fonts) {
  const float size = fonts.small.size;
  const float scale = fonts.scale;
  const float middle = at.y + size * 0.55F;
  const ImU32 colour = packed(drawing::colour(entry.stroke.role));
  if (entry.mark == drawing::LegendMark::Patch) {
    list->AddRectFilled({at.x + length * 0.25F, middle - size * 0.4F},
                        {at.x + length * 0.75F, middle + size * 0.4F}, colour, 2 * scale);
    return;
  }
  if (entry.mark == drawing::LegendMark::Dot) {
    list->AddCircleFilled({at.x + length * 0.5F, middle}, size * 0.35F, colour);
    return;
  }
  const float width = scale * std::clamp(entry.stroke.width, 1.5F, 4.0F);
  const float gap = entry.stroke.dashed ? length / 5 : 0;
  if (drawing::needs_outline(entry.stroke.role)) {
    list->AddLine({at.x, middle}, {at.x + length, middle}, ink, width + 2 * scale);
  }
  if (gap > 0) {
    for (const float start : {0.0F, 2 * gap, 4 * gap}) {
      list->AddLine({at.x + start, middle}, {at.x + start + gap, middle}, colour, width);
    }
  } else {
    list->AddLine({at.x, middle}, {at.x + length, middle}, colour, width);
  }
  if (entry.stroke.arrow) {
    list->AddTriangleFilled({at.x + length + 3 * scale, middle},
                            {at.x + length - 5 * scale, middle - 4.5F * scale},
                            {at.x + length - 5 * scale, middle + 4.5F * scale}, colour);
  }
}

/// A rectangle of text (pixels).
struct Box {
  float left;
  float top;
  float right;
  float bottom;

  bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool is_inside(const Area& area) const {
    return area.left <= left && right <= area.left + area.width && area.top <= top &&
           bottom <= area.top + area.height;
  }
};

bool is_inside(const Vec2& pixel, const Area& area) {
  const Box point{pixel.x(), pixel.y(), pixel.x(), pixel.y()};
  return point.is_inside(area);
}

/// A free place for a text beside a point: to the upper right, at another corner, or farther away.
/// One that leaves the area is the last resort. Nothing if all of these overlap other texts.
std::optional<Box> free_place(const Vec2& point, ImVec2 size, float gap, const Area& area,
                              std::span<const Box> taken) {
  const auto at = [&](bool right, bool above, float line) {
    const float left = std::floor(right ? point.x() + gap : point.x() - gap - size.x);
    const float shift = gap / 2 + line * size.y;
    const float top = std::floor(above ? point.y() - shift - size.y : point.y() + shift);
    return Box{left, top, left + size.x, top + size.y};
  };
  std::optional<Box> last_resort;
  for (const float line : {0.0F, 1.0F, 2.0F}) {
    for (const auto& [right, above] :
         {std::pair{true, true}, {true, false}, {false, true}, {false, false}}) {
      const Box box = at(right, above, line);
      const bool is_free = std::none_of(taken.begin(), taken.end(),
                                        [&](const Box& other) { return box.overlaps(other); });
      if (is_free && box.is_inside(area)) return box;
      if (is_free && !last_resort) last_resort = box;
    }
  }
  return last_resort;
}

}  // namespace

int show_labels(const drawing::Drawing& drawing, const Projection& projection, const Area& area,
                const Fonts& fonts) {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  list->PushClipRect({area.left, area.top}, {area.left + area.width, area.top + area.height});
  std::vector<Box> taken;
  int missing = 0;
  for (const drawing::Label& label : drawing.labels) {
    if (!projection.is_in_front(label.position)) continue;
    const Vec2 pixel = projection.pixel(label.position);
    if (!is_inside(pixel, area)) continue;
    const ImVec2 size =
        fonts.small.font->CalcTextSizeA(fonts.small.size, FLT_MAX, 0, label.text.c_str());
    const std::optional<Box> box = free_place(pixel, size, 6 * fonts.scale, area, taken);
    if (!box) {
      ++missing;
      continue;
    }
    taken.push_back(*box);
    haloed_text(list, fonts, {box->left, box->top}, packed(readable(label.role)),
                label.text.c_str());
  }
  list->PopClipRect();
  return missing;
}

void show_legend(const drawing::Drawing& drawing, const Area& area, const Fonts& fonts,
                 int missing_labels) {
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const float size = fonts.small.size;
  const float line = size + 6 * fonts.scale;
  const float sample = 2 * size;
  const float margin = 16 * fonts.scale;
  const float wrap = area.width - 2 * margin;
  float top = area.top + area.height - margin;
  std::vector<std::string> notes = drawing.notes;
  if (missing_labels > 0) {
    notes.push_back("No room for " + std::to_string(missing_labels) +
                    (missing_labels == 1 ? " label" : " labels") + ": zoom in.");
  }
  for (auto note = notes.rbegin(); note != notes.rend(); ++note) {
    const float height =
        fonts.small.font->CalcTextSizeA(size, FLT_MAX, wrap, note->c_str()).y + line - size;
    top -= height;
    haloed_text(list, fonts, {area.left + margin, top}, ink, note->c_str(), wrap);
  }
  for (auto entry = drawing.legend.rbegin(); entry != drawing.legend.rend(); ++entry) {
    top -= line;
    draw_sample(list, *entry, {area.left + margin, top}, sample, fonts);
    haloed_text(list, fonts, {area.left + margin + sample + 10 * fonts.scale, top}, ink,
                entry->text.c_str());
  }
}

void show_problem(const std::string& problem, const Area& area, const Fonts& fonts) {
  ImDrawList* list = ImGui::GetForegroundDrawList();
  const float size = fonts.text.size;
  const float padding = 18 * fonts.scale;
  const float wrap = std::min(area.width - 6 * padding, 32 * size);
  const ImVec2 text = fonts.text.font->CalcTextSizeA(size, FLT_MAX, wrap, problem.c_str());
  const Vec2 middle = area.center();
  const ImVec2 corner(std::floor(middle.x() - text.x / 2), std::floor(middle.y() - text.y / 2));
  const ImVec2 upper(corner.x - padding, corner.y - padding);
  const ImVec2 lower(corner.x + text.x + padding, corner.y + text.y + padding);
  list->AddRectFilled(upper, lower, paper, 6 * fonts.scale);
  add_outline(list, upper, lower, warning_ink, 6 * fonts.scale, 1.5F * fonts.scale);
  list->AddText(fonts.text.font, size, corner, warning_ink, problem.c_str(), nullptr, wrap);
}

}  // namespace cs550::viewer
