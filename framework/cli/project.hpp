#pragma once
/// @file project.hpp
/// Where things are in the repository, and how they are built.

#include <filesystem>
#include <string>
#include <vector>

namespace cs550::cli {

/// The root of the repository: what the launcher says, else the nearest folder above the current
/// one that holds it. Throws std::runtime_error when there is none.
std::filesystem::path project_root();

/// The folders of tests/ that belong to a lab, `lab3_hill_climbing`, in the order of their numbers.
std::vector<std::string> lab_names();

/// The number of a lab, from its name: 3 for `lab3_hill_climbing`.
int lab_number(const std::string& lab_name);

/// The lab with this number; empty when there is none.
std::string lab_name(int number);

/// Builds a target quietly, through the launcher, which shows the compiler's message if it fails.
/// @return whether the target is now up to date
bool build(const std::string& preset, const std::string& target);

/// A program that a build made.
std::filesystem::path built_program(const std::string& preset, const std::string& name);

}  // namespace cs550::cli
