#pragma once
/// @file source_name.hpp
/// Which files of a lab's folder are handed in, taken and compiled.

#include <filesystem>
#include <string>

namespace cs550::files {

/// Whether its extension is that of C++ code, also of code that is only included.
bool is_source(const std::filesystem::path& file);
/// For messages: ".cpp, .hpp, ...".
std::string source_extensions();

/// Whether a name needs no care in a command or a message: letters, digits and _-. only, and / between them.
bool has_plain_name(const std::filesystem::path& file);
/// The name with _ in place of every other character.
std::string plain_name(const std::filesystem::path& file);

}  // namespace cs550::files
