#pragma once
/// @file window.hpp
/// The viewer in a window.

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "viewer/app.hpp"
#include "viewer/options.hpp"

namespace cs550::viewer {

/// There is no screen to open a window on.
class NoScreen : public std::runtime_error {
 public:
  /// @param instead the command that takes a picture without a screen
  NoScreen(const std::string& reason, std::string instead)
      : std::runtime_error(reason), instead_(std::move(instead)) {}
  const std::string& instead() const { return instead_; }

 private:
  std::string instead_;
};

/// Called with the viewer after each frame. The window closes when it returns false.
using Observer = std::function<bool(App& app)>;

/// Opens a window and returns when it is closed.
/// @param observe for tests
/// @throws NoScreen without a screen
/// @throws std::runtime_error if no window can be opened
void run_in_window(const Options& options, const Observer& observe = {});

}  // namespace cs550::viewer
