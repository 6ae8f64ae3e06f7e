// The panels beside the picture: pages, scenes, buttons, facts, settings, plots.
#include <imgui/imgui.h>

#include <algorithm>

#include "cs550/scene.hpp"
#include "viewer/app.hpp"
#include "viewer/ui/control_widgets.hpp"
#include "viewer/ui/imgui_calls.hpp"
#include "viewer/ui/plot_widget.hpp"

namespace cs550::viewer {
namespace {

constexpr float plot_height = 148;  ///< pixels at scale 1
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_fixed(const char* name, const Area& area) {
  ImGui::SetNextWindowPos({area.left, area.top});
  ImGui::SetNextWindowSize({area.width, area.height});
  ImGui::Begin(name, nullptr, fixed_window);
}

void show_heading(const std::string& title, const std::string& story, const Fonts& fonts) {
  ImGui::Spacing();
  push_font(fonts.title);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, quiet_ink);
  ImGui::TextUnformatted(story.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
}

}  // namespace

void App::show_panel(const Layout& layout) {
  begin_fixed("panel", layout.panel);
  show_pages();
  show_heading(title(), page_->story(), interface_.fonts());
  if (world_ != nullptr) show_scenes();
  show_transport();
  show_facts();
  {
    ControlWidgets widgets;
    page_->describe(widgets);
  }
  if (layout.plots_are_inside) show_plots_below();
  ImGui::End();
}

void App::show_pages() {
  const float gap = 3 * interface_.scale();
  const float world_width = 62 * interface_.scale();
  const float rest = ImGui::GetContentRegionAvail().x - world_width;
  const float lab_width = rest / lab_page_count - gap;
  for (int lab = 0; lab <= lab_page_count; ++lab) {
    if (lab > 0) ImGui::SameLine(0, gap);
    const bool is_here = lab == page_->lab();
    if (is_here) {
      ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 96, 160, 255));
      ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(0, 96, 160, 255));
      ImGui::PushStyleColor(ImGuiCol_Text, paper);
    }
    const std::string name = lab == 0 ? "World" : std::to_string(lab);
    const bool clicked = ImGui::Button(name.c_str(), {lab == 0 ? world_width : lab_width, 0});
    if (is_here) ImGui::PopStyleColor(3);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", page_name(lab));
    if (clicked) return show_page(lab);
  }
  if (failure_ == nullptr || page_ == failure_) return;
  const std::string back = "Back to " + failure_->title();
  if (ImGui::Button(back.c_str(), {-1, 0})) open(failure_page);
}

void App::show_scenes() {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##scene", options_.scene.c_str())) return;
  for (const std::string& name : shipped_scenes()) {
    if (ImGui::Selectable(name.c_str(), name == options_.scene)) {
      options_.scene = name;
      world_->load(name);
      world_->refresh();
      frame_focus();
    }
  }
  ImGui::EndCombo();
}

void App::show_transport() {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::BeginDisabled(!can_step());
  if (ImGui::Button(plays_ ? "Pause" : "Play", {width, 0})) toggle_play();
  ImGui::SameLine();
  if (ImGui::Button("Step", {width, 0})) advance();
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Reset", {width, 0})) reset();
  if (world_ == nullptr) return;
  constexpr const char* speeds[] = {"full speed", "1/2 speed", "1/4 speed", "1/8 speed"};
  int speed = 0;
  while (1 << speed < slowness_) ++speed;
  ImGui::SetNextItemWidth(2 * width + gap);
  if (ImGui::Combo("##speed", &speed, speeds, 4)) slowness_ = 1 << speed;
  ImGui::SameLine();
  if (ImGui::Button("Throw", {width, 0})) {
    world_->throw_box(camera_.eye(), camera_.target - camera_.eye());
  }
}

void App::show_facts() const {
  const std::vector<Fact>& facts = page_->content().facts;
  if (facts.empty()) return;
  ImGui::Spacing();
  if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.4F);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.6F);
    for (const Fact& fact : facts) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, quiet_ink);
      ImGui::TextUnformatted(fact.name.c_str());
      ImGui::PopStyleColor();
      ImGui::TableNextColumn();
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(fact.value.c_str());
      ImGui::PopTextWrapPos();
    }
    ImGui::EndTable();
  }
  ImGui::Spacing();
}

void App::show_plots(const Area& area) const {
  const std::vector<drawing::Plot>& plots = page_->content().plots;
  begin_fixed("plots", area);
  const auto count = static_cast<float>(plots.size());
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const float room = ImGui::GetContentRegionAvail().y / count - gap;
  const float wanted =
      std::clamp(room, plot_height * interface_.scale(), 1.6F * plot_height * interface_.scale());
  for (const drawing::Plot& plot : plots) show_plot(plot, wanted, interface_.fonts());
  ImGui::End();
}

void App::show_plots_below() const {
  if (!ImGui::CollapsingHeader("Plots", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const drawing::Plot& plot : page_->content().plots) {
    show_plot(plot, plot_height * interface_.scale(), interface_.fonts());
  }
}

}  // namespace cs550::viewer
