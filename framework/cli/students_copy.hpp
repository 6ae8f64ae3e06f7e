#pragma once
/// @file students_copy.hpp
/// What students get: the committed state of this repository without what only instructors may see.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// Writes the students' copy into an empty folder: starters in labs/ and, pristine, in .starters/;
/// no solutions but those of labs 1..released; no hidden tests, mutants or instructors' tests;
/// manifests reduced to the visible tests; the students' README.
/// Throws std::runtime_error where there is no git history, or the copy cannot be written.
void write_students_copy(const std::filesystem::path& folder, int released);

/// Gives the copy a history of its own: one commit by CS550.
void start_history(const std::filesystem::path& folder);

/// What an update did.
struct CopyUpdate {
  int files_replaced = 0;
  std::vector<std::string> kept;       ///< lab files that the student has changed
  std::vector<std::string> conflicts;  ///< among them, those whose starter has changed as well
};

/// Brings a students' copy up to a fresh one. A lab file that differs from the copy's own starter
/// is never touched; files that the copy no longer has are removed; the student's own files stay.
CopyUpdate update_copy(const std::filesystem::path& copy, const std::filesystem::path& fresh);

/// Files of a copy that it lists as its own, relative to it.
std::vector<std::string> files_of_copy(const std::filesystem::path& copy);

}  // namespace cs550::cli
