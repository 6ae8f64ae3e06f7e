#pragma once
/// @file page.hpp
/// One subject of the viewer: what can be set, and what is shown.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isolation/service.hpp"
#include "pages/base/camera.hpp"
#include "pages/base/content.hpp"
#include "pages/base/controls.hpp"

namespace cs550::pages {

using isolation::Isolation;

/// A page of the viewer. Its content depends on its settings, and for the world also on time.
class Page {
 public:
  Page() = default;
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  virtual ~Page() = default;

  /// Number of the lab; 0 for the world.
  virtual int lab() const = 0;
  /// A few words.
  virtual std::string title() const = 0;
  /// What is to be seen and why it matters, in a sentence or two.
  virtual std::string story() const = 0;
  /// Visits every setting.
  virtual void describe(ControlVisitor& visit) = 0;
  /// Brings the content up to date with the settings.
  virtual void refresh() = 0;
  /// What refresh() found.
  virtual const Content& content() const = 0;
  /// From where the page is best seen; only yaw and pitch matter.
  virtual Camera first_view() const { return {}; }
  /// One step on: of time, of a walk, of an algorithm. Wraps around where there is an end.
  virtual void advance() = 0;
  /// To the beginning of a walk.
  virtual void rewind() {}
  /// A point in the picture that the user may drag, if there is one (world, m).
  virtual std::optional<Vec3> handle() const { return {}; }
  /// Where it was dragged to.
  virtual void move_handle(const Vec3& /*point*/) {}
};

/// How many labs have a page.
inline constexpr int lab_page_count = 7;
/// The names of the pages, of the world first.
const char* page_name(int lab);

}  // namespace cs550::pages
