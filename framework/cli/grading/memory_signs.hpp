#pragma once
/// @file memory_signs.hpp
/// Signs of a memory error in a test that did not crash, but compared wrong values.

#include <filesystem>
#include <string>

#include "cli/grading/graded_tests.hpp"
#include "cli/system/process.hpp"

namespace cs550::cli {

/// Suggests --asan for a failed test if its report changes with the contents of freed memory, or if it got
/// a value that is not a number. Names other likely reasons if the report changes when the test runs alone. Runs
/// the test twice, if it is short. Empty for other failures: an unwritten step, a crash, an ordinary wrong value.
/// @param program that ran the test, without sanitizers
std::string memory_advice(const std::filesystem::path& program, int lab, const Verdict& failure,
                          const Limits& limits = {});

}  // namespace cs550::cli
