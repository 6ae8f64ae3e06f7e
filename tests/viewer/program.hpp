#pragma once
/// @file program.hpp
/// Running the viewer as its users do.

#include <string>
#include <vector>

namespace cs550::test {

/// How a program ended, and what it said.
struct Outcome {
  int exit_code = -1;  ///< −1 if a signal ended it
  std::string output;  ///< standard output and error
};

/// Runs a program to its end.
Outcome run_program(const std::vector<std::string>& command);

/// A program that runs until this object goes away.
class Background {
 public:
  /// @param output what its standard output goes to: a file descriptor, or −1 for nowhere
  Background(const std::vector<std::string>& command, int output);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

 private:
  int process_;
};

/// Whether a program of this name is found along PATH.
bool is_installed(const std::string& program);

}  // namespace cs550::test
