#pragma once
/// @file path_argument.hpp
/// Paths from a command line.

#include <string>

namespace cs550::files {

/// Why a word cannot name a file or folder: it is empty, or longer than the system's names. Empty if it
/// can. Whether something has that name is not asked.
std::string fault_of_path(const std::string& word);

/// Why a file of one kind is not written there: its name has another ending, so that it might replace a file of
/// another kind. Empty if it has that ending, or is the name of something else than a file, or of nothing that can
/// be reached.
/// @param ending such as ".png"
std::string fault_of_ending(const std::string& word, const std::string& ending);

}  // namespace cs550::files
