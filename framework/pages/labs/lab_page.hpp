#pragma once
/// @file lab_page.hpp
/// The page of a lab: a pure function of its settings. A child process can run it.

#include <algorithm>
#include <optional>
#include <utility>

#include "pages/base/content_archive.hpp"
#include "pages/base/page.hpp"

namespace cs550::pages {

/// The parts of a lab's page. `Settings` is comparable and has a member `int step`, the displayed
/// step of a walk. A negative one counts from the end.
template <class Settings>
struct LabPageParts {
  int lab = 0;             ///< its number
  const char* story = "";  ///< what the page shows
  Camera first_view;       ///< only yaw and pitch matter
  Settings settings;       ///< initial values
  /// Visits the settings.
  void (*describe)(Settings& settings, ControlVisitor& visit) = nullptr;
  /// Makes the content. It calls functions of the lab, which may throw, crash or never return.
  Content (*show)(const Settings& settings) = nullptr;
  /// The points that can be dragged, and what a drag does; null if there are none. See Page.
  /// @{
  std::vector<Handle> (*handles)(const Settings& settings) = nullptr;
  void (*move_handle)(Settings& settings, std::size_t handle, const Vec3& point) = nullptr;
  void (*turn_handle)(Settings& settings, std::size_t handle, const Vec3& rotation) = nullptr;
  /// @}
};

/// The index of the displayed step. A negative step counts from the end.
inline int shown_step(int step, int count) {
  return std::clamp(step < 0 ? step + count : step, 0, std::max(count - 1, 0));
}

/// The page of a lab.
template <class Settings>
class LabPage final : public Page {
 public:
  LabPage(LabPageParts<Settings> parts, Isolation isolation)
      : parts_(std::move(parts)), isolation_(isolation), settings_(parts_.settings) {}

  int lab() const override { return parts_.lab; }
  std::string title() const override { return page_name(parts_.lab); }
  std::string story() const override { return parts_.story; }
  void describe(ControlVisitor& visit) override { parts_.describe(settings_, visit); }
  const Content& content() const override { return content_; }
  Camera first_view() const override { return parts_.first_view; }

  void refresh() override {
    if (shown_ && *shown_ == settings_) return;
    shown_ = settings_;
    using Nothing = int;
    isolation::Service<Nothing, Content> service(
        [this](const Nothing&) { return parts_.show(settings_); }, isolation_);
    isolation::Answer<Content> answer = service.ask(0);
    if (answer.failure.empty()) {
      content_ = std::move(answer.value);
      content_.drawing = drawing::finite_part(content_.drawing);
    } else {
      content_ = {};
      content_.problem = answer.failure;
    }
  }

  void advance() override {
    if (!shown_) refresh();
    const int count = content_.step_count;
    if (count < 2) return;  // "last" remains the last step of the next walk
    settings_.step = (shown_step(settings_.step, count) + 1) % count;
  }

  void rewind() override { settings_.step = 0; }

  std::vector<Handle> handles() const override {
    if (parts_.handles == nullptr) return {};
    return parts_.handles(settings_);
  }
  void move_handle(std::size_t handle, const Vec3& point) override {
    if (point.allFinite()) parts_.move_handle(settings_, handle, point);
  }
  void turn_handle(std::size_t handle, const Vec3& rotation) override {
    if (rotation.allFinite()) parts_.turn_handle(settings_, handle, rotation);
  }

 private:
  LabPageParts<Settings> parts_;
  Isolation isolation_;
  Settings settings_;
  std::optional<Settings> shown_;
  Content content_;
};

/// The pages of the labs.
/// @{
std::unique_ptr<Page> make_integration_page(Isolation isolation);
std::unique_ptr<Page> make_half_edge_page(Isolation isolation);
std::unique_ptr<Page> make_climb_page(Isolation isolation);
std::unique_ptr<Page> make_axis_page(Isolation isolation);
std::unique_ptr<Page> make_clipping_page(Isolation isolation);
std::unique_ptr<Page> make_naive_page(Isolation isolation);
std::unique_ptr<Page> make_constraint_page(Isolation isolation);
/// @}

}  // namespace cs550::pages
