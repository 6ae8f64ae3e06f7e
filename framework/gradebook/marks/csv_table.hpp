#pragma once
/// @file csv_table.hpp
/// Reading CSV files (RFC 4180).

#include <string>
#include <vector>

namespace cs550::gradebook {

/// Rows of fields. The separator is the comma, or the semicolon if the first line has no comma.
/// A byte order mark and empty lines are skipped.
/// @param file its name in messages
/// Throws std::runtime_error for a quote that is not closed: it would swallow the lines after it.
std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& file);

}  // namespace cs550::gradebook
