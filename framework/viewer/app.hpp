#pragma once
/// @file app.hpp
/// The viewer: a page, a camera and panels, driven by a window or a snapshot.

#include <imgui/imgui.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "pages/make_page.hpp"
#include "pages/world/world_page.hpp"
#include "viewer/options.hpp"
#include "viewer/render/content_renderer.hpp"
#include "viewer/ui/interface.hpp"
#include "viewer/ui/layout.hpp"

namespace cs550::viewer {

using namespace pages;

/// The viewer's state from frame to frame.
class App {
 public:
  /// Opens the page that the options select, and applies their settings and steps.
  /// @throws std::invalid_argument for a setting that does not exist
  App(const Options& options, Interface& interface);

  /// One frame: handles input, advances if playing, and draws everything.
  void draw(Canvas& canvas);
  /// Advances the page by one step.
  void advance() { page_->advance(); }
  /// Restarts the page. That of a failing test returns to its first drawing.
  void reset();
  /// Whether there is another step: always in the world, on other pages if they have several.
  bool can_step() const { return world_ != nullptr || page_->content().step_count > 1; }
  /// Plays or pauses. Without a step there is nothing to play.
  void toggle_play() { plays_ = !plays_ && can_step(); }
  /// Frames all content, seen from the page's initial direction.
  void frame_focus();
  /// Shows or hides the panels.
  void toggle_panels() { options_.ui = !options_.ui; }
  /// Throws a box towards the mouse.
  void throw_box();
  /// Which of a page's handles a key moves: A or B, where it has two.
  enum class Nudged : std::uint8_t { First, Last };
  /// Moves a handle in the plane of the picture. @param right, up -1, 0 or 1
  void nudge(Nudged nudged, Real right, Real up);
  /// Opens the page of a lab; 0 is the world, failure_page the failing test of the options.
  void open(int lab);
  /// The same, unless it is the present page, whose settings would be lost.
  void show_page(int lab);
  /// Leaves out timings, so that the same command produces the same picture.
  void hide_times();

  const Page& page() const { return *page_; }
  /// The page's title. It names the student's code as such where a page runs it.
  std::string title() const;
  const Camera& camera() const { return camera_; }
  /// Where panels and picture are.
  Layout layout() const;
  bool plays() const { return plays_; }
  /// Whether the picture has been unchanged for several frames and can be redrawn at full quality.
  bool is_still() const;
  /// The projection of a point (pixels from the top left).
  Vec2 pixel_of(const Vec3& point) const { return projection().pixel(point); }
  /// The world, or null on the page of a lab.
  WorldPage* world() { return world_; }

 private:
  /// What the mouse holds on the page of a lab.
  struct Grip {
    std::size_t handle = 0;       ///< index in the page's handles
    ImGuiMouseButton button = 0;  ///< held down: the left one moves, the right one turns
    Real depth = 0;               ///< of the point from the eye, along the view (m)
  };

  Camera first_camera() const;
  void frame_first();
  void hear_mouse();
  void hear_drag_of_body(const Vec2& mouse);
  void hear_drag_of_handle(const Vec2& mouse);
  std::optional<Grip> grip_at(const Vec2& mouse, ImGuiMouseButton button) const;
  Vec3 at_depth(const Vec2& mouse, Real depth) const;
  void pass_time();
  Area picture_area() const { return layout().picture; }
  void show_panel(const Layout& layout);
  void show_pages();
  void show_transport();
  void show_scenes();
  void show_facts() const;
  void show_plots(const Area& area) const;
  void show_plots_below() const;
  Projection projection() const;

  Options options_;
  Interface& interface_;
  ContentRenderer renderer_;
  std::shared_ptr<Page> page_;
  std::shared_ptr<Page> failure_;  ///< kept, because the next passing test removes its picture
  WorldPage* world_ = nullptr;
  Camera camera_;
  Camera framed_;  ///< by the last frame_focus()
  bool plays_ = false;
  int slowness_ = 1;         ///< the clock's speed over the world's
  double waiting_time_ = 0;  ///< since the last step, as a share of the time for one
  bool hides_times_ = false;
  std::optional<Real> drag_depth_;  ///< of a dragged body's point from the eye, along the view (m)
  std::optional<Grip> grip_;
};

}  // namespace cs550::viewer
