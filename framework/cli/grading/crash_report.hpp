#pragma once
/// @file crash_report.hpp
/// What a sanitizer or an assertion printed, shortened for a student.

#include <string>

namespace cs550::cli {

/// From a program's output, what a sanitizer or an assertion reported: what happened, and the lines
/// of labs/ and tests/ that led to it, innermost first. Empty when there was no report.
std::string crash_report(const std::string& output);

/// The lines of such a report without what happened: where the program was.
std::string calls_in(const std::string& report);

/// Makes programs that are started from now on print the calls that led to undefined behaviour, to a failed
/// assertion or to where they are stopped, and end before they fill the memory. Settings in the user's environment are kept.
void configure_sanitizers();

}  // namespace cs550::cli
