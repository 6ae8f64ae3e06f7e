#pragma once
/// @file print.hpp
/// A report as text of at most 80 columns.

#include <iosfwd>

#include "benchmarks/report/report.hpp"

namespace cs550::bench {

/// @param out standard output; parts that were not measured are left out
void print(const Report& report, std::ostream& out);

}  // namespace cs550::bench
