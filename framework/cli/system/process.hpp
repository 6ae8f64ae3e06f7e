#pragma once
/// @file process.hpp
/// Running other programs.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cs550::cli {

/// How a program ended.
struct Ending {
  int exit_code = 0;     ///< meaningful when signal is 0
  int signal = 0;        ///< that killed it, or 0
  bool stopped = false;  ///< whether we killed it, since it made no progress

  bool good() const { return exit_code == 0 && signal == 0; }
  /// Whether it was stopped since it printed more than Limits::output.
  bool printed_too_much() const;
  /// For a program that should not have ended: "crashed: Segmentation fault".
  std::string in_words() const;
};

/// What a program may use. One with limits leaves no core file.
struct Limits {
  std::uint64_t memory = 0;  ///< its address space (bytes), or 0 for any
  std::uint64_t output = 0;  ///< what it writes to one file (bytes), or 0 for any
};

/// Of a program with students' code, which may allocate or print without end.
Limits students_limits(bool sanitized);

/// Where a program runs, and until when.
struct Surroundings {
  std::filesystem::path folder;  ///< its working directory; empty: ours
  std::filesystem::path output;  ///< file for its standard output and error; empty: ours
  /// Called every few milliseconds: whether the program is stuck and must be stopped.
  std::function<bool()> is_stuck = [] { return false; };
  Limits limits = {};  ///< of what it uses
  /// Stops it, followed by SIGKILL if it still runs after 10 s. At SIGTERM a program of ours removes what is
  /// unfinished, and at SIGABRT a sanitizer prints the calls that led to where the program is.
  int stop_signal = SIGTERM;
};

/// Runs a program to its end. The first word is the program, found along PATH.
/// Throws std::system_error when it cannot be started.
Ending run(const std::vector<std::string>& command, const Surroundings& surroundings = {});

/// What a program has printed to a file: only the beginning if that was too much.
std::string read_output(const std::filesystem::path& file, const Ending& ending);

/// What a program prints. Throws std::runtime_error, with what it printed, when it fails.
std::string output_of(const std::vector<std::string>& command,
                      const std::filesystem::path& folder = {});

/// Replaces this process by another program. Throws std::system_error when it cannot be started.
[[noreturn]] void become(const std::vector<std::string>& command);

}  // namespace cs550::cli
