#pragma once
/// @file compile.hpp
/// From a submission's sources to a library that a worker can load.

#include <filesystem>
#include <string>

#include "autograder/grader/order.hpp"

namespace cs550::grader {

struct Compilation {
  bool succeeded = false;
  double seconds = 0;
  std::string errors;  ///< the first ones of the compiler, or why it was not started; at most 4 kB
  /// Whether it was stopped for its time or by a machine without memory. Another try may succeed.
  bool was_stopped = false;
};

/// Students' own tests of a lab, beside its files.
inline constexpr const char* own_tests_file = "my_tests.cpp";

/// What of a lab's folder is compiled.
enum class Part {
  Code,     ///< the .cpp files of the folder itself, but own_tests_file
  OwnTests  ///< own_tests_file alone
};

/// Copies the sources of a lab and compiles a part of them, where nothing else but
/// the contract and the system's headers can be seen.
/// @param source the lab's files as in labs/labN_topic/
/// @param lab_name "lab3_hill_climbing"
/// @param library the result. The lab's starter, which it is linked with, is copied to the folder of it
/// @param order isolation, limits, and when the time for the lab is over
/// @throws std::runtime_error if this machine cannot compile anything, for lack of disk space for example
Compilation compile(const std::filesystem::path& source, const std::string& lab_name,
                    const std::filesystem::path& library, const Order& order,
                    Part part = Part::Code);

}  // namespace cs550::grader
