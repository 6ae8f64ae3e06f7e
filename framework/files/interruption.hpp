#pragma once
/// @file interruption.hpp
/// Signals that ask a program to end, as a flag and as exceptions, so that destructors remove what
/// is unfinished.

#include <atomic>

namespace cs550::files {

/// From now on SIGINT, SIGTERM and SIGHUP set a flag; a second one of the same kind ends the
/// process at once. SIGHUP stays ignored if it is, as after nohup.
void watch_for_interruption();

/// The flag.
const std::atomic<bool>& interrupted();

/// @throws std::runtime_error if the flag is set
void throw_if_interrupted();

}  // namespace cs550::files
