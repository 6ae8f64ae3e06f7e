#pragma once
/// @file live_figure.hpp
/// A figure that answers: a page of the viewer as SVG, with its settings. The book's static picture
/// and the browser's live one are both made here.

#include <cstddef>
#include <memory>
#include <string>

#include "drawing/view.hpp"
#include "pages/base/page.hpp"
#include "world_canvas.hpp"

namespace cs550::live {

/// A page with a camera that turns about what the page focuses on.
class LiveFigure {
 public:
  /// @param description the number of a page and settings: "4 gauss_maps=off turn=0,0,45". Page 0
  /// takes scene=NAME too.
  /// @throws std::invalid_argument with the reason
  explicit LiveFigure(const std::string& description);

  /// @param assignment name=value @throws std::invalid_argument with the reason
  void set(const std::string& assignment);
  /// The settings as JSON: a list of {kind, name, label, unit, value, least, most, names}. That of page 0
  /// begins with the scene.
  std::string describe();
  /// One step of the walk or of time.
  void advance() { page_->advance(); }
  /// Begins the walk or the scene again.
  void rewind();
  /// Moves one of the page's handles in the plane of the picture. @param right, up multiples of the
  /// focus's radius
  void move(std::size_t handle, Real right, Real up);
  /// Turns the body around a handle, so that its front follows. @param right, up rad
  void turn(std::size_t handle, Real right, Real up);

  /// Of page 0: its picture on a canvas, on which bodies are picked and thrown. Null on other pages.
  WorldCanvas* canvas() { return canvas_.get(); }

  /// Turns the camera (rad).
  void orbit(Real yaw, Real pitch) { camera_.orbit(yaw, pitch); }
  /// Multiplies the camera's distance, on a canvas.
  void zoom(Real factor) { camera_.zoom(factor); }
  /// The picture. @param size pixels
  std::string svg(const drawing::Size& size = {640, 420});
  /// A plot beside it; empty if there is none of that number.
  std::string plot_svg(std::size_t plot);
  /// What is said beside the picture, as JSON: title, story, walks, canvas, h,
  /// steps, plots, handles, problem, facts.
  std::string facts();

 private:
  void choose_scene(const std::string& name);

  std::unique_ptr<pages::Page> page_;
  pages::WorldPage* world_ = nullptr;  ///< page_, where that is the world
  std::string scene_;
  pages::Camera camera_;
  std::unique_ptr<WorldCanvas> canvas_;
};

}  // namespace cs550::live
