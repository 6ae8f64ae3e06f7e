#include "viewer/ui/control_widgets.hpp"

#include <imgui/imgui.h>

namespace cs550::viewer {
namespace {

constexpr float label_share = 0.47F;  ///< of a line

std::string hidden_label(const Control& control) { return std::string("##") + control.name; }

std::string number_format(const Control& control, const char* number) {
  return *control.unit == '\0' ? number : std::string(number) + " " + control.unit;
}

}  // namespace

void ControlWidgets::section(const char* title) {
  end_row();
  is_open_ = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
}

void ControlWidgets::end_row() { half_row_used_ = false; }

void ControlWidgets::begin_row(const Control& control) {
  end_row();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(control.label);
  ImGui::SameLine(ImGui::GetWindowWidth() * label_share);
  ImGui::SetNextItemWidth(-1);
}

void ControlWidgets::slider(const Control& control, int& value, int least, int most,
                            const std::string& format) {
  if (!is_open_) return;
  begin_row(control);
  ImGui::SliderInt(hidden_label(control).c_str(), &value, least, most, format.c_str(),
                   ImGuiSliderFlags_AlwaysClamp);
}

void ControlWidgets::whole(const Control& control, int& value, int least, int most) {
  const bool is_named = value == -1 && control.minus_one != nullptr;
  slider(control, value, least, most, is_named ? control.minus_one : number_format(control, "%d"));
}

void ControlWidgets::number(const Control& control, Real& value, Real least, Real most) {
  if (!is_open_) return;
  begin_row(control);
  ImGui::SliderFloat(hidden_label(control).c_str(), &value, least, most,
                     number_format(control, "%.3g").c_str(), ImGuiSliderFlags_AlwaysClamp);
}

void ControlWidgets::vector(const Control& control, Vec3& value, Real most) {
  if (!is_open_) return;
  begin_row(control);
  ImGui::DragFloat3(hidden_label(control).c_str(), value.data(), most / 200, -most, most, "%.3g",
                    ImGuiSliderFlags_AlwaysClamp);
  if (*control.unit != '\0' && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", control.unit);
}

void ControlWidgets::toggle(const Control& control, bool& value) {
  if (!is_open_) return;
  const float half = ImGui::GetWindowWidth() * 0.54F;
  const float label = ImGui::CalcTextSize(control.label).x + 2 * ImGui::GetFrameHeight();
  const bool fits = label < ImGui::GetWindowWidth() - half;
  if (half_row_used_ && fits) ImGui::SameLine(half);
  ImGui::Checkbox((std::string(control.label) + hidden_label(control)).c_str(), &value);
  half_row_used_ = !(half_row_used_ && fits) && label < half;
}

void ControlWidgets::choice(const Control& control, int& value,
                            std::span<const char* const> names) {
  if (!is_open_) return;
  begin_row(control);
  ImGui::Combo(hidden_label(control).c_str(), &value, names.data(), static_cast<int>(names.size()));
}

/// A button for each move, and one that undoes the last move.
void ControlWidgets::moves(const Control& control, std::vector<int>& value,
                           std::span<const char* const> names) {
  if (!is_open_) return;
  end_row();
  ImGui::PushID(control.name);
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
