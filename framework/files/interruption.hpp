#pragma once
/// @file interruption.hpp
/// Ctrl-C and SIGTERM as exceptions, so that destructors remove what is unfinished.

namespace cs550::files {

/// From now on SIGINT and SIGTERM set a flag; a second one ends the process at once.
void watch_for_interruption();

/// @throws std::runtime_error after SIGINT or SIGTERM
void throw_if_interrupted();

}  // namespace cs550::files
