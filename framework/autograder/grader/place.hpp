#pragma once
/// @file place.hpp
/// Where the project must not be, so that submissions see nothing of it.

#include <algorithm>
#include <array>
#include <filesystem>

namespace cs550::grader {

/// Folders of the system that the compiler and a worker read.
inline constexpr std::array seen_by_submissions{"/usr", "/lib", "/lib32", "/lib64", "/bin"};

/// Whether submissions could read a file or folder at this path.
/// @param path absolute, without symbolic links
inline bool is_seen_by_submissions(const std::filesystem::path& path) {
  return std::any_of(
      seen_by_submissions.begin(), seen_by_submissions.end(),
      [&path](const std::filesystem::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
               folder.end();
      });
}

}  // namespace cs550::grader
