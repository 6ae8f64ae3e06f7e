#pragma once
/// @file interruption.hpp
/// Signals that ask a program to end, as a flag and as exceptions, so that destructors remove what
/// is unfinished.

#include <atomic>
#include <cstdint>

namespace cs550::files {

/// What a second signal of the same kind does.
enum class SecondSignal : std::uint8_t {
  Ends,       ///< the process, at once
  IsIgnored,  ///< as in a process whose parent passes on a signal that both have got, and kills it later
};

/// From now on SIGINT, SIGTERM and SIGHUP set a flag. SIGHUP stays ignored if it is, as after nohup.
void watch_for_interruption(SecondSignal second = SecondSignal::Ends);

/// The flag.
const std::atomic<bool>& interrupted();

/// @throws std::runtime_error if the flag is set
void throw_if_interrupted();

}  // namespace cs550::files
