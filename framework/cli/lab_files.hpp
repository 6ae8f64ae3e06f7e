#pragma once
/// @file lab_files.hpp
/// The files that a student edits, and the starters that they began as.

#include <filesystem>
#include <string>

namespace cs550::cli {

/// The file that the student edits: labs/lab3_hill_climbing/hill_climbing.cpp.
std::filesystem::path lab_file(const std::string& lab_name);

/// The pristine starter's text: from .starters/ in a students' copy, else as last committed.
/// Throws std::runtime_error where there is neither.
std::string starter_text(const std::string& lab_name);

/// Whether the student's file still is the starter; false where no starter is known.
bool is_untouched(const std::string& lab_name);

/// Puts the starter in place of the student's file, which stays beside it
/// as topic.cpp.bak-1, -2, ...
/// @return the backup; empty when the file was the starter already
std::filesystem::path reset_to_starter(const std::string& lab_name);

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
