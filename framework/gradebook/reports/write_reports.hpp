#pragma once
/// @file write_reports.hpp
/// All reports on a class, made from its records.

#include <filesystem>
#include <vector>

#include "gradebook/course/course.hpp"
#include "gradebook/marks/roster.hpp"

namespace cs550::gradebook {

/// Writes grades.csv and class.html for the class, and a file per record in gradescope/, junit/,
/// classroom/ and feedback/. Files of an earlier report are replaced.
void write_reports(const std::filesystem::path& folder, const std::vector<Record>& records,
                   const std::vector<Student>& roster, const Course& course);

}  // namespace cs550::gradebook
