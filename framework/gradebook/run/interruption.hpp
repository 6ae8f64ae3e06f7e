#pragma once
/// @file interruption.hpp
/// Ctrl-C ends a run in an orderly way.

#include <atomic>

namespace cs550::gradebook {

/// Becomes true on SIGINT, SIGTERM or SIGHUP. From the first call on, these signals no longer end
/// the program, and a file that exceeds a size limit is an error of the write instead of a signal.
const std::atomic<bool>& interrupted();

}  // namespace cs550::gradebook
