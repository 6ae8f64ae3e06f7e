#pragma once
/// @file crash_report.hpp
/// What a sanitizer or an assertion printed, shortened for a student.

#include <string>

namespace cs550::cli {

/// From a program's output, what a sanitizer or an assertion reported: what happened, and the lines
/// of labs/ and tests/ that led to it, innermost first. Empty when there was no report.
std::string crash_report(const std::string& output);

}  // namespace cs550::cli
