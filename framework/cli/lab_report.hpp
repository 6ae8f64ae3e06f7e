#pragma once
/// @file lab_report.hpp
/// How the verdicts on a lab are shown.

#include <string>
#include <vector>

#include "verdict.hpp"

namespace cs550::cli {

/// A lab's name as people say it: "Lab 3: hill climbing".
std::string title(const std::string& lab_name);

/// Why a word is not the number of a lab, and which labs there are; empty when it is one.
std::string fault_of_lab_number(const std::string& word);

/// One line for each test, and what it said. The same words are not said twice in a row: an
/// unwritten function stops many tests.
void print(const std::vector<Verdict>& verdicts);

/// Points and tests passed, and how many points are graded elsewhere.
void print_total(const std::vector<Verdict>& verdicts, int elsewhere);

}  // namespace cs550::cli
