#pragma once
/// @file viewer_program.hpp
/// The program that shows the engine. It is built apart, so that nothing else needs its packages.

#include <string>
#include <vector>

namespace cs550::cli {

/// Whether its packages were there when this program was configured.
bool has_viewer();

/// Builds the viewer, quietly, and returns the command that starts it; empty if it cannot be built.
/// @param student on the student's labs; in a students' copy there are no others
/// @param preset that builds it
std::vector<std::string> viewer_command(bool student, const std::string& preset);

}  // namespace cs550::cli
