#pragma once
/// @file lab_files.hpp
/// The files that a student edits, and the starters that they began as.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// What the student writes: every .cpp and .hpp in the lab's folder, such as
/// labs/lab3_hill_climbing/hill_climbing.cpp, sorted by name.
std::vector<std::filesystem::path> lab_files(const std::string& lab_name);

/// Tells whether lab_files() have changed: their SHA-256, one after the other.
std::string fingerprint(const std::string& lab_name);

/// Whether the student's files still are the starter; false where no starter is known.
bool is_untouched(const std::string& lab_name);

/// Puts the starter in place of the student's files. Those that were another text stay beside it as
/// topic.cpp.bak-1, -2, ...
/// Throws std::runtime_error where no starter is known: it is in .starters/ of a students' copy, else
/// as last committed.
/// @return the backups; none when the files were the starter already
std::vector<std::filesystem::path> reset_to_starter(const std::string& lab_name);

/// Whether a file in a folder, or further down, was written after a moment.
bool has_newer_file(const std::filesystem::path& folder, std::filesystem::file_time_type moment);

/// The whole of a file. Throws std::runtime_error when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// Replaces a file in one move: a reader sees the old text or the new one.
/// Throws std::runtime_error when it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

/// SHA-256 of a file, 64 hexadecimal digits.
std::string sha256(const std::filesystem::path& file);

}  // namespace cs550::cli
