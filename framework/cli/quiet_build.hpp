#pragma once
/// @file quiet_build.hpp
/// Building behind the scenes.

#include <string>

namespace cs550::cli {

/// Builds a target of preset `student` with nothing on the screen.
/// @return the compiler's first error; empty when all is well
std::string build_quietly(const std::string& target);

}  // namespace cs550::cli
