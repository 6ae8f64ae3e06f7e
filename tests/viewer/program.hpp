#pragma once
/// @file program.hpp
/// Runs the viewer as its users do.

#include <string>
#include <vector>

namespace cs550::test {

/// The exit code and output of a program.
struct Outcome {
  int exit_code = -1;  ///< −1 if a signal ended it
  std::string output;  ///< standard output and error
};

/// Runs a program and waits for its end.
Outcome run_program(const std::vector<std::string>& command);

/// A program that runs until this object is destroyed.
class Background {
 public:
  /// @param output file descriptor of its standard output, or −1 to discard it
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
