#include "viewer/ui/knob_widgets.hpp"

#include <imgui/imgui.h>

namespace cs550::viewer {
namespace {

constexpr float label_share = 0.47F;  ///< of a line

std::string hidden_label(const Knob& knob) { return std::string("##") + knob.name; }

std::string number_format(const Knob& knob, const char* number) {
  return *knob.unit == '\0' ? number : std::string(number) + " " + knob.unit;
}

}  // namespace

void KnobWidgets::section(const char* title) {
  end_row();
  is_open_ = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
}

void KnobWidgets::end_row() { half_row_used_ = false; }

void KnobWidgets::begin_row(const Knob& knob) {
  end_row();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(knob.label);
  ImGui::SameLine(ImGui::GetWindowWidth() * label_share);
  ImGui::SetNextItemWidth(-1);
}

void KnobWidgets::whole(const Knob& knob, int& value, int least, int most) {
  if (!is_open_) return;
  begin_row(knob);
  ImGui::SliderInt(hidden_label(knob).c_str(), &value, least, most,
                   number_format(knob, "%d").c_str(), ImGuiSliderFlags_AlwaysClamp);
}

void KnobWidgets::number(const Knob& knob, Real& value, Real least, Real most) {
  if (!is_open_) return;
  begin_row(knob);
  ImGui::SliderFloat(hidden_label(knob).c_str(), &value, least, most,
                     number_format(knob, "%.3g").c_str(), ImGuiSliderFlags_AlwaysClamp);
}

void KnobWidgets::vector(const Knob& knob, Vec3& value, Real most) {
  if (!is_open_) return;
  begin_row(knob);
  ImGui::DragFloat3(hidden_label(knob).c_str(), value.data(), most / 200, -most, most, "%.3g",
                    ImGuiSliderFlags_AlwaysClamp);
  if (*knob.unit != '\0' && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", knob.unit);
}

void KnobWidgets::toggle(const Knob& knob, bool& value) {
  if (!is_open_) return;
  const float half = ImGui::GetWindowWidth() * 0.54F;
  const float label = ImGui::CalcTextSize(knob.label).x + 2 * ImGui::GetFrameHeight();
  const bool fits = label < ImGui::GetWindowWidth() - half;
  if (half_row_used_ && fits) ImGui::SameLine(half);
  ImGui::Checkbox((std::string(knob.label) + hidden_label(knob)).c_str(), &value);
  half_row_used_ = !(half_row_used_ && fits) && label < half;
}

void KnobWidgets::choice(const Knob& knob, int& value, std::span<const char* const> names) {
  if (!is_open_) return;
  begin_row(knob);
  ImGui::Combo(hidden_label(knob).c_str(), &value, names.data(), static_cast<int>(names.size()));
}

/// A button for each move, and one that takes the last move back.
void KnobWidgets::moves(const Knob& knob, std::vector<int>& value,
                        std::span<const char* const> names) {
  if (!is_open_) return;
  end_row();
  ImGui::PushID(knob.name);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const auto count = static_cast<float>(names.size() + 1);
  const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ImGui::Button(names[i], {width, 0})) value.push_back(static_cast<int>(i));
    ImGui::SameLine();
  }
  if (ImGui::Button("back", {width, 0}) && !value.empty()) value.pop_back();
  ImGui::PopID();
}

}  // namespace cs550::viewer
