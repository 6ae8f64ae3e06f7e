#pragma once
/// @file page.hpp
/// A page of the viewer: its settings and its content.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "isolation/service.hpp"
#include "pages/base/camera.hpp"
#include "pages/base/content.hpp"
#include "pages/base/controls.hpp"

namespace cs550::pages {

using isolation::Isolation;

/// A point that the user can drag: the middle of a body, the tip of an arrow.
struct Handle {
  std::string name;    ///< "A"
  Vec3 point;          ///< world (m)
  bool turns = false;  ///< whether the body around it can be turned as well
};

/// A page of the viewer. Its content depends on its settings, and for the world also on time.
class Page {
 public:
  Page() = default;
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  virtual ~Page() = default;

  /// Number of the lab; 0 for the world, failure_page for a failing test.
  virtual int lab() const = 0;
  /// The heading.
  virtual std::string title() const = 0;
  /// One or two sentences about what the page shows and why it matters.
  virtual std::string story() const = 0;
  /// Visits every setting.
  virtual void describe(ControlVisitor& visit) = 0;
  /// Updates the content to match the settings.
  virtual void refresh() = 0;
  /// The result of the last refresh().
  virtual const Content& content() const = 0;
  /// The initial direction of view; only yaw and pitch are used.
  virtual Camera first_view() const { return {}; }
  /// Advances by one step of time, of a walk or of an algorithm. The last is followed by the first.
  virtual void advance() = 0;
  /// Returns to the first step of a walk.
  virtual void rewind() {}
  /// The points that the user can drag.
  virtual std::vector<Handle> handles() const { return {}; }
  /// Moves a dragged point. @param handle index in handles() @param point world (m)
  virtual void move_handle(std::size_t /*handle*/, const Vec3& /*point*/) {}
  /// Turns the body around a point. @pre its Handle::turns @param rotation vector, world (rad)
  virtual void turn_handle(std::size_t /*handle*/, const Vec3& /*rotation*/) {}
};

/// Number of labs with a page.
inline constexpr int lab_page_count = 7;
/// Stands for the page of a failing test where others have the number of a lab.
inline constexpr int failure_page = -1;
/// The names of the pages, starting with the world.
const char* page_name(int lab);

}  // namespace cs550::pages
