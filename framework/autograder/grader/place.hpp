#pragma once
/// @file place.hpp
/// Where the project and its references must not be, so that submissions see nothing of them.

#include <array>
#include <filesystem>

namespace cs550::grader {

/// Folders of the system that the compiler and a worker read.
inline constexpr std::array seen_by_submissions{"/usr", "/lib", "/lib32", "/lib64", "/bin"};

/// Whether submissions could read a file or folder at this path.
/// @param path absolute, without symbolic links
bool is_seen_by_submissions(const std::filesystem::path& path);

/// A library of an installed engine (cmake --install), which has the reference of all labs.
/// @param system a folder such as /usr
/// @return empty if no folder for libraries has one
std::filesystem::path installed_engine(const std::filesystem::path& system);

}  // namespace cs550::grader
