#pragma once
/// @file lab_files.hpp
/// The files that a student edits, and the starters that they began as.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cs550::cli {

/// What may be compiled into the lab: all files in its folder and subfolders, such as
/// labs/lab3_hill_climbing/hill_climbing.cpp, but for the handout, its figures, backups, hidden files and the
/// student's tests; sorted by name.
std::vector<std::filesystem::path> lab_files(const std::string& lab_name);

/// What the student hands in: those of these files that are code with a plain name, and the tests that the
/// student has written.
std::vector<std::filesystem::path> files_to_submit(const std::string& lab_name);

/// The others of these files.
std::vector<std::filesystem::path> files_left_out(const std::string& lab_name);

/// Changes when anything changes that a result of the lab depends on: the lab's files, its tests,
/// given code, and the other labs that its tests are linked with. In a students' copy those are the
/// student's earlier labs; no test of a lab calls a later one.
std::string fingerprint(const std::string& lab_name);

/// Whether other labs' tests are linked with the reference of this lab, not with the student's
/// code. A students' copy has the reference of released labs only.
bool has_reference(const std::string& lab_name);

/// Why a lab cannot be built; empty if it has a .cpp file.
std::string fault_of_absent_code(const std::string& lab_name);

/// Whether the student's files still are the starter; false where no starter is known.
bool is_untouched(const std::string& lab_name);

/// Whether there is nothing to hand in but the starter.
bool is_nothing_to_submit(const std::string& lab_name);

/// Puts the starter in place of the student's files. Those that differ from it are kept beside it
/// as topic.cpp.bak-1, -2, ...
/// Throws std::runtime_error where no starter is known: it is in .starters/ of a students' copy,
/// else in the last commit.
/// @return the backups; nothing when the files were the starter already
std::optional<std::vector<std::filesystem::path>> reset_to_starter(const std::string& lab_name);

/// Copies the lab's solution in place of the student's files, which are kept as above.
/// Throws std::runtime_error where the solution is absent: a students' copy has released ones only.
/// @return the backups; nothing when the files were the solution already
std::optional<std::vector<std::filesystem::path>> use_solution(const std::string& lab_name);

}  // namespace cs550::cli
