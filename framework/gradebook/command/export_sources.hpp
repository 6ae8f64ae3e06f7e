#pragma once
/// @file export_sources.hpp
/// Submissions laid out for tools that look for copied code.

#include <filesystem>
#include <vector>

namespace cs550::gradebook {

/// Writes FOLDER/labN/submissions/NAME/ with each student's files, and FOLDER/labN/base/ with the
/// starter, and prints the commands for JPlag and MOSS.
/// @param folder must be new or empty
void export_sources(const std::filesystem::path& root,
                    const std::vector<std::filesystem::path>& submissions,
                    const std::filesystem::path& folder);

}  // namespace cs550::gradebook
