#pragma once
/// @file files.hpp
/// Reading files and folders.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// The whole of a file. Throws std::runtime_error when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// All files in a folder and its subfolders, sorted; none when it is absent.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// SHA-256 of a file, 64 hexadecimal digits.
std::string sha256(const std::filesystem::path& file);

/// Changes when the name or the content of one of the files changes (FNV-1a, 16 hexadecimal
/// digits). A file that cannot be opened counts as absent.
std::string fingerprint_of(const std::vector<std::filesystem::path>& files);

}  // namespace cs550::cli
