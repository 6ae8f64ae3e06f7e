#pragma once
/// @file lab_report.hpp
/// How the verdicts on a lab are shown.

#include <string>
#include <vector>

#include "graded_run.hpp"

namespace cs550::cli {

/// A lab's name as people say it: "Lab 3: hill climbing".
std::string title(const std::string& lab_name);

/// Says so, and which labs there are.
/// @return the exit code for wrong usage
int no_such_lab(int number);

/// One line for each test, and what it said. The same words are not said twice in a row: an
/// unwritten function stops many tests.
void print(const std::vector<Verdict>& verdicts);

/// Points and tests passed, and how many points are graded elsewhere.
void print_total(const std::vector<Verdict>& verdicts, int elsewhere);

}  // namespace cs550::cli
