#pragma once
/// @file process.hpp
/// Running other programs.

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cs550::cli {

/// How a program ended.
struct Ending {
  int exit_code = 0;     ///< meaningful when signal is 0
  int signal = 0;        ///< what killed it, or 0
  bool stopped = false;  ///< we stopped it: it had come to a standstill

  bool good() const { return exit_code == 0 && signal == 0; }
  /// Why it did not come to its own end, for people: "crashed: Segmentation fault".
  std::string in_words() const;
};

/// What surrounds a program that runs.
struct Surroundings {
  std::filesystem::path folder;  ///< where it starts; empty: here
  std::filesystem::path output;  ///< takes its standard output and error; empty: ours
  /// Asked every few milliseconds: has it come to a standstill, so that it must be stopped?
  std::function<bool()> stands_still = [] { return false; };
};

/// Runs a program to its end. The first word is the program, found along PATH.
/// Throws std::system_error when it cannot be started.
Ending run(const std::vector<std::string>& command, const Surroundings& surroundings = {});

/// What a program prints on its way to success.
/// Throws std::runtime_error, with what it printed, when it fails.
std::string output_of(const std::vector<std::string>& command,
                      const std::filesystem::path& folder = {});

/// Becomes another program. Throws std::system_error when it cannot be started.
[[noreturn]] void become(const std::vector<std::string>& command);

}  // namespace cs550::cli
