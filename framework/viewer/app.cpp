#include "viewer/app.hpp"

#include <imgui/imgui.h>

#include <algorithm>

#include "cs550/scene.hpp"
#include "viewer/ui/captions.hpp"
#include "viewer/ui/imgui_calls.hpp"
#include "viewer/ui/knob_widgets.hpp"
#include "viewer/ui/plot_widget.hpp"

namespace cs550::viewer {
namespace {

constexpr float plot_height = 148;            ///< pixels at scale 1
constexpr Real turn_per_pixel = Real(0.006);  ///< rad
constexpr int frames_per_lab_step = 24;       ///< of a lab's walk: slow enough to follow
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

Vec2 mouse_position() {
  const ImVec2 position = ImGui::GetIO().MousePos;
  return {position.x, position.y};
}

Size display_size() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return {static_cast<int>(size.x), static_cast<int>(size.y)};
}

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

App::App(const Options& options, Interface& interface) : options_(options), interface_(interface) {
  open(options.lab);
  if (options.steps || options.is_sequence()) page_->rewind();
  for (const std::string& assignment : options.settings) {
    KnobSetter setter(assignment);
    page_->describe(setter);
    setter.expect_found();
  }
  const int default_steps = world_ != nullptr ? options.default_steps() : 0;
  const int steps = options.steps.value_or(default_steps);
  if (world_ != nullptr) {
    if (steps > 0) world_->take_steps(steps);
  } else {
    for (int i = 0; i < steps; ++i) page_->advance();
  }
  page_->refresh();
  frame_focus();
  if (!options.camera.empty()) camera_ = parse_camera(options.camera, camera_);
}

void App::open(int lab) {
  const Isolation isolation = options_.student ? Isolation::Child : Isolation::Here;
  page_ = make_page({lab, options_.scene, isolation});
  world_ = dynamic_cast<WorldPage*>(page_.get());
  if (world_ != nullptr) world_->show_times(!hides_times_);
  drag_depth_.reset();
  plays_ = false;
  page_->refresh();
  frame_focus();
}

void App::reset() {
  if (world_ != nullptr) {
    world_->reset();
  } else {
    open(page_->lab());
  }
}

void App::frame_focus() {
  const Focus& focus = page_->content().focus;
  camera_ = fitted(page_->first_view(), focus.center, focus.radius);
}

void App::hide_times() {
  hides_times_ = true;
  if (world_ != nullptr) world_->show_times(false);
}

void App::throw_box() {
  if (world_ == nullptr) return;
  const Projection seen = projection();
  const Vec3 ray = seen.ray(mouse_position());
  world_->throw_box(camera_.eye(), camera_.eye() + ray);
}

// --- a frame ---------------------------------------------------------------------------------

void App::draw(Canvas& canvas) {
  interface_.begin_frame(canvas.size(), options_.ui);
  hear_mouse();
  pass_time();
  page_->refresh();
  const Layout places = layout();
  if (places.panel.width > 0) show_panel(places);
  if (places.plots.width > 0) show_plots(places.plots);
  const float pixels_per_unit =
      static_cast<float>(canvas.size().width) / ImGui::GetIO().DisplaySize.x;
  const Projection seen = projection();
  const Content& content = page_->content();
  painter_.paint(content, seen, canvas, interface_.scale() * pixels_per_unit);
  const int missing = show_labels(content.drawing, seen, picture_area(), interface_.fonts());
  show_legend(content.drawing, picture_area(), interface_.fonts(), missing);
  if (!content.problem.empty()) {
    show_problem(content.problem, picture_area(), interface_.fonts());
  }
  interface_.end_frame();
}

bool App::is_still() const {
  constexpr int a_while = 8;  // frames
  return painter_.still_frames() >= a_while;
}

void App::pass_time() {
  if (!plays_) return;
  const int wait = world_ != nullptr ? slowness_ : frames_per_lab_step;
  if (++frames_since_step_ < wait) return;
  frames_since_step_ = 0;
  page_->advance();
}

Layout App::layout() const {
  if (!options_.ui) return picture_only(display_size());
  return lay_out(display_size(), interface_.scale(), !page_->content().plots.empty());
}

Projection App::projection() const { return {camera_, display_size(), picture_area()}; }

// --- mouse -----------------------------------------------------------------------------------

void App::hear_mouse() {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 mouse = mouse_position();
  if (world_ != nullptr) {
    hear_drag_of_body(mouse);
  } else {
    hear_drag_of_handle(mouse);
  }
  if (io.WantCaptureMouse || drag_depth_) return;
  const Vec2 change(io.MouseDelta.x, io.MouseDelta.y);
  const bool shifts = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                      (io.KeyShift && ImGui::IsMouseDown(ImGuiMouseButton_Left));
  const bool turns =
      ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (shifts) {
    camera_.pan(change, picture_area());
  } else if (turns) {
    camera_.orbit(-turn_per_pixel * change.x(), turn_per_pixel * change.y());
  }
  if (io.MouseWheel != 0) camera_.zoom(std::pow(Real(0.9), io.MouseWheel));
}

/// A body that is pressed is selected, and follows the mouse at the distance at which it was.
void App::hear_drag_of_body(const Vec2& mouse) {
  const Projection seen = projection();
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (pressed && !ImGui::GetIO().WantCaptureMouse && !ImGui::GetIO().KeyShift) {
    const auto hit = world_->pick(seen.eye(), seen.ray(mouse));
    const bool can_move = hit && world_->frame().bodies[static_cast<std::size_t>(hit->body)].kind ==
                                     BodyKind::Dynamic;
    world_->select(can_move ? std::optional(hit->body) : std::nullopt);
    if (can_move) {
      world_->grab(*hit);
      drag_depth_ = (hit->point - seen.eye()).dot(seen.forward());
    }
  }
  if (!drag_depth_) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    world_->drag_to(dragged_to(mouse));
  } else {
    world_->let_go();
    drag_depth_.reset();
  }
}

/// The tip of an arrow, the middle of a body: what a page lets the user move.
void App::hear_drag_of_handle(const Vec2& mouse) {
  constexpr Real reach = 18;  // pixels
  const std::optional<Vec3> handle = page_->handle();
  if (!handle) return;
  const Projection seen = projection();
  const bool pressed =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::GetIO().WantCaptureMouse;
  if (pressed && seen.is_in_front(*handle) &&
      (seen.pixel(*handle) - mouse).norm() < reach * interface_.scale()) {
    drag_depth_ = (*handle - seen.eye()).dot(seen.forward());
  }
  if (!drag_depth_) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    page_->move_handle(dragged_to(mouse));
  } else {
    drag_depth_.reset();
  }
}

/// The point under the mouse at the distance at which the drag began.
Vec3 App::dragged_to(const Vec2& mouse) const {
  const Projection seen = projection();
  const Vec3 ray = seen.ray(mouse);
  return seen.eye() + *drag_depth_ / ray.dot(seen.forward()) * ray;
}

// --- panels ----------------------------------------------------------------------------------

void App::show_panel(const Layout& layout) {
  begin_fixed("panel", layout.panel);
  show_pages();
  show_heading(page_->title(), page_->story(), interface_.fonts());
  if (world_ != nullptr) show_scenes();
  show_transport();
  show_facts();
  {
    KnobWidgets widgets;
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
    if (clicked && !is_here) {
      open(lab);
      return;
    }
  }
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
  if (ImGui::Button(plays_ ? "Pause" : "Play", {width, 0})) toggle_play();
  ImGui::SameLine();
  if (ImGui::Button("Step", {width, 0})) advance();
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
    world_->throw_box(camera_.eye(), camera_.target);
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
