#pragma once
/// @file debugging.hpp
/// Opening gdb where a student's code fails.

#include <string>
#include <vector>

namespace cs550::cli {

/// What to do after `--debug` with code that does not end.
inline constexpr const char* how_to_find_a_loop = "Ctrl-C 5 s after gdb starts shows the loop";

/// Builds a program of the preset `student` and runs it in gdb up to its first exception or crash. Without
/// a terminal it only prints the calls that led there.
/// @param what is run, for the introduction: "HillClimbMatchesBruteForce"
/// @return an ExitCode
int run_in_gdb(const std::string& target, const std::vector<std::string>& arguments,
               const std::string& what);

}  // namespace cs550::cli
