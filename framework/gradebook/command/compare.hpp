#pragma once
/// @file compare.hpp
/// What a regrade changed.

#include <string>
#include <vector>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// Every lab, test and bonus whose points or status differ, by submission; then a sentence with the
/// totals.
std::string comparison(const std::vector<Record>& before, const std::vector<Record>& after);

}  // namespace cs550::gradebook
