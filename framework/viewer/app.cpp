#include "viewer/app.hpp"

#include <imgui/imgui.h>

#include <algorithm>

#include "viewer/ui/captions.hpp"

namespace cs550::viewer {
namespace {

constexpr double seconds_per_lab_step = 0.4;  ///< of a lab's walk: slow enough to follow
constexpr int steps_at_once = 4;              ///< of a world, before the clock is read
constexpr double most_time_of_steps = 0.04;   ///< s, in a frame: a slower world falls behind
constexpr double rounding_of_time = 1e-3;     ///< steps: a frame may be as long as a step
constexpr double most_due = 1e6;              ///< steps, more than a frame has time for

Size display_size() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return {static_cast<int>(size.x), static_cast<int>(size.y)};
}

}  // namespace

App::App(const Options& options, Interface& interface) : options_(options), interface_(interface) {
  open(options.page().lab);
  if (options.steps || options.is_sequence()) page_->rewind();
  for (const std::string& assignment : options.settings) {
    ControlSetter setter(assignment);
    page_->describe(setter);
    setter.expect_found();
  }
  page_->refresh();  // The settings determine how many steps a walk has.
  const int default_steps = world_ != nullptr ? options.default_steps() : 0;
  const int steps = options.steps.value_or(default_steps);
  if (world_ != nullptr) {
    if (steps > 0) world_->take_steps(steps);
  } else {
    for (int i = 0; i < steps; ++i) page_->advance();
  }
  page_->refresh();
  frame_first();
}

void App::open(int lab) {
  PageChoice choice = options_.page();
  choice.lab = lab;
  const bool was_read = lab == failure_page && failure_ != nullptr;
  page_ = was_read ? failure_ : make_page(choice);
  if (lab == failure_page) failure_ = page_;
  world_ = dynamic_cast<WorldPage*>(page_.get());
  if (world_ != nullptr) world_->show_times(!hides_times_);
  drag_depth_.reset();
  grip_.reset();
  plays_ = false;
  page_->refresh();
  frame_focus();
}

void App::show_page(int lab) {
  if (lab != page_->lab()) open(lab);
}

void App::reset() {
  if (world_ != nullptr) {
    world_->reset();
  } else if (page_->lab() == failure_page) {
    page_->rewind();
  } else {
    open(page_->lab());
  }
}

Camera App::first_camera() const {
  const Focus& focus = page_->content().focus;
  return fitted(page_->first_view(), focus.center, focus.radius);
}

void App::frame_focus() {
  framed_ = first_camera();
  camera_ = framed_;
}

void App::frame_first() {
  frame_focus();
  if (!options_.camera.empty()) camera_ = parse_camera(options_.camera, camera_);
}

void App::hide_times() {
  hides_times_ = true;
  if (world_ != nullptr) world_->show_times(false);
}

std::string App::title() const {
  const bool runs_own_code = options_.student && page_->lab() != failure_page;
  return page_->title() + (runs_own_code ? " (your code)" : "");
}

// --- a frame ---------------------------------------------------------------------------------

void App::draw(Canvas& canvas) {
  interface_.begin_frame(canvas.size(), options_.ui);
  hear_mouse();
  pass_time();
  page_->refresh();
  // The panels of a failing test may show different places, and from different sides.
  if (page_->lab() == failure_page && !(first_camera() == framed_)) frame_first();
  const Layout places = layout();
  if (places.panel.width > 0) show_panel(places);
  if (places.plots.width > 0) show_plots(places.plots);
  const float pixels_per_unit =
      static_cast<float>(canvas.size().width) / ImGui::GetIO().DisplaySize.x;
  const Projection seen = projection();
  const Content& content = page_->content();
  renderer_.paint(content, seen, canvas, interface_.scale() * pixels_per_unit);
  const int missing = show_labels(content.drawing, seen, picture_area(), interface_.fonts());
  show_legend(content.drawing, picture_area(), interface_.fonts(), missing);
  if (!content.problem.empty()) {
    show_problem(content.problem, picture_area(), interface_.fonts());
  }
  interface_.end_frame();
}

bool App::is_still() const {
  constexpr int a_while = 8;  // frames
  return renderer_.still_frames() >= a_while;
}

/// The world keeps pace with the clock, whatever the rate of the display and the length of a step.
/// If the steps take too long, it falls behind. Without a window a picture takes a sixtieth of a second.
void App::pass_time() {
  plays_ = plays_ && can_step();
  if (!plays_) {
    waiting_time_ = 0;
    return;
  }
  const double step = world_ != nullptr ? static_cast<double>(world_->step_length()) * slowness_
                                        : seconds_per_lab_step;
  waiting_time_ += static_cast<double>(ImGui::GetIO().DeltaTime) / step;
  waiting_time_ = std::min(waiting_time_, most_due);
  int due = static_cast<int>(waiting_time_ + rounding_of_time);
  if (due == 0) return;
  waiting_time_ -= due;
  if (world_ == nullptr) {
    page_->advance();
    return;
  }
  for (; due > 0 && interface_.time_in_frame() < most_time_of_steps; due -= steps_at_once) {
    world_->take_steps(std::min(due, steps_at_once));
  }
  if (due > 0) waiting_time_ = 0;
}

Layout App::layout() const {
  if (!options_.ui) return picture_only(display_size());
  return lay_out(display_size(), interface_.scale(), !page_->content().plots.empty());
}

Projection App::projection() const { return {camera_, display_size(), picture_area()}; }

}  // namespace cs550::viewer
