#pragma once
/// @file window.hpp
/// The viewer in a window.

#include <functional>

#include "viewer/app.hpp"
#include "viewer/options.hpp"

namespace cs550::viewer {

/// Called with the viewer after each frame. The window closes when it returns false.
using Observer = std::function<bool(App& app)>;

/// Opens a window and returns when it is closed.
/// @param observe for tests
/// @throws std::runtime_error if no window can be opened
void run_in_window(const Options& options, const Observer& observe = {});

}  // namespace cs550::viewer
