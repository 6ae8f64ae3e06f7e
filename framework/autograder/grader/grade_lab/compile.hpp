#pragma once
/// @file compile.hpp
/// From a submission's sources to a library that a worker can load.

#include <filesystem>
#include <string>

#include "autograder/grader/sandbox.hpp"

namespace cs550::grader {

struct Compilation {
  bool succeeded = false;
  double seconds = 0;
  std::string errors;  ///< the first ones of the compiler, or why it was not started; at most 4 kB
};

/// Copies the sources of a lab and compiles the .cpp files of its own folder, where nothing else but
/// the contract and the system's headers can be seen.
/// @param source the lab's files as in labs/labN_topic/
/// @param lab_name "lab3_hill_climbing"
/// @param library the result
Compilation compile(const std::filesystem::path& source, const std::string& lab_name,
                    const std::filesystem::path& library, Isolation isolation,
                    const Limits& limits);

}  // namespace cs550::grader
