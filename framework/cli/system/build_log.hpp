#pragma once
/// @file build_log.hpp
/// What the compiler reported in the last build of preset `student`, with paths relative to the project.

#include <string>
#include <vector>

namespace cs550::cli {

/// The first error of the step that stopped the build, or its last line if it printed none.
std::string first_build_error();

/// Whether the first error of the last build is the student's, so that the next build has it too. It may also be in a
/// template of a header, or the linker's. A full disk, a missing package and a compiler that was killed are not.
/// An error that is not recognised counts as the machine's: that costs another build only.
bool is_students_error(const std::string& error);

/// The warnings of the student's own files, each once. None if nothing was compiled.
std::vector<std::string> own_warnings();

/// The counter of a build that is running, "[12/65]"; empty before it counts.
std::string build_progress();

}  // namespace cs550::cli
