#pragma once
/// @file window.hpp
/// The viewer in a window.

#include "viewer/options.hpp"

namespace cs550::viewer {

/// Opens a window and returns when it is closed.
/// @throws std::runtime_error that says why there is none
void run_in_window(const Options& options);

}  // namespace cs550::viewer
