#pragma once
/// @file view.hpp
/// The viewer, a program of its own: nothing else needs its packages.

#include <string>
#include <vector>

namespace cs550::cli {

/// Whether the viewer's packages were present when this program was configured.
bool has_viewer();

/// Builds the viewer and returns the command that starts it; empty if it cannot be built.
/// @param student on the student's labs; a students' copy has no others
/// @param preset that builds it
std::vector<std::string> viewer_command(bool student, const std::string& preset);

}  // namespace cs550::cli
