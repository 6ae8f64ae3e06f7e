#pragma once
/// @file viewer.hpp
/// The viewer, a program of its own: nothing else needs its packages.

#include <string>
#include <vector>

namespace cs550::cli {

/// Builds the viewer and returns the command that starts it; empty if it cannot be built.
/// @param student on the student's labs; a students' copy has no others
std::vector<std::string> viewer_command(bool student);

}  // namespace cs550::cli
