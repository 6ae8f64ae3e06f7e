#pragma once
/// @file path_argument.hpp
/// Paths from a command line.

#include <string>

namespace cs550::files {

/// Why a word cannot name a file or folder: it is empty, or longer than the system's names. Empty if it
/// can. Whether something has that name is not asked.
std::string fault_of_path(const std::string& word);

}  // namespace cs550::files
