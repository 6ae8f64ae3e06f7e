#pragma once
/// @file csv_table.hpp
/// Reading CSV files (RFC 4180).

#include <string>
#include <vector>

namespace cs550::gradebook {

/// Rows of fields. The separator is the comma, or the semicolon if the first line has no comma.
/// A byte order mark and empty lines are skipped.
std::vector<std::vector<std::string>> parse_csv(const std::string& text);

}  // namespace cs550::gradebook
