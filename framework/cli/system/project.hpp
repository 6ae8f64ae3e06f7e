#pragma once
/// @file project.hpp
/// Where things are in the repository, and how they are built.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// The root of the repository: CS550_ROOT, which the launcher sets, else the nearest folder above
/// the current one that is a root. Throws std::runtime_error when there is none.
std::filesystem::path project_root();

/// The project's own folder. Its root may be a folder of links to it, as with CS550_BUILD_DIR.
std::filesystem::path behind_links(const std::filesystem::path& root);

/// Whether files of the project differ from its last commit. Throws std::runtime_error when Git cannot tell.
bool has_uncommitted_changes(const std::filesystem::path& root);

/// The folders of tests/ that belong to a lab, `lab3_hill_climbing`, in the order of their numbers.
std::vector<std::string> lab_names();

/// A lab's name for people: "Lab 3: hill climbing".
std::string title(const std::string& lab_name);

/// The number of a lab as the folders spell it: "5" for "05", "lab5" and "L5". Any other word stays as it is.
std::string plain_lab_number(const std::string& typed);

/// Why a word is not the number of a lab, with a list of the labs; empty when it is one.
std::string fault_of_lab_number(const std::string& word);

/// The number of the lab that a step belongs to: 3 for "L3.2".
int lab_number_of_step(const std::string& step);

/// The lab that a step belongs to: `lab3_hill_climbing` for "L3.2".
std::string lab_of_step(const std::string& step);

/// Whether this is a students' copy, which `starter` makes.
bool is_students_copy();

/// In a students' copy: the project's version, and the commit that it was made from.
inline constexpr const char* starter_version_file = ".starters/version";

/// The version of a students' copy, "1.0 0123456789ab"; empty for any other folder.
std::string starter_version(const std::filesystem::path& copy);

/// The number of a lab, from its name: 3 for `lab3_hill_climbing`.
int lab_number(const std::string& lab_name);

/// The lab with this number; empty when there is none.
std::string lab_name(int number);

/// A file in build/results for what another program prints. It is this process's own: a second ./cs550 may run
/// at the same time.
std::filesystem::path draft_result(const std::string& name);

/// Builds a target through the launcher, which prints the compiler's message if it fails.
/// @return whether the target is now up to date
bool build(const std::string& preset, const std::string& target);

/// Builds a target of preset `student`. A status line shows how far it has come; nothing else is printed.
/// @return the compiler's first error; empty when the target is up to date
std::string build_quietly(const std::string& target);

/// The file of a program that a build makes.
std::filesystem::path built_program(const std::string& preset, const std::string& name);

}  // namespace cs550::cli
