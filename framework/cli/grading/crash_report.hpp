#pragma once
/// @file crash_report.hpp
/// What a sanitizer or an assertion printed, shortened for a student.

#include <string>

namespace cs550::cli {

/// From a program's output, what a sanitizer or an assertion reported: what happened, and the lines
/// of labs/ and tests/ that led to it, innermost first. Empty when there was no report.
std::string crash_report(const std::string& output);

/// Makes programs that are started from now on print the calls that led to undefined behaviour or to a
/// failed assertion, and stop before they fill the memory. Settings in the user's environment are kept.
void configure_sanitizers();

}  // namespace cs550::cli
