#pragma once
/// @file usage_fault.hpp
/// Messages about a wrong command line.

#include <string>

namespace cs550::files {

/// What is wrong, in our words where the library that parses command lines has none for a reader.
/// @param words the library's
std::string usage_fault(const std::string& words);

}  // namespace cs550::files
