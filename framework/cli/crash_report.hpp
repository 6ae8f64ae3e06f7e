#pragma once
/// @file crash_report.hpp
/// What a program said when it was stopped.

#include <string>

namespace cs550::cli {

/// The few lines of a sanitizer's or an assertion's output that a student can use: what happened,
/// and the places in labs/ and tests/ that led there, innermost first. Empty when neither said
/// anything.
std::string crash_report(const std::string& output);

}  // namespace cs550::cli
