#pragma once
/// @file class_page.hpp
/// The overview of a class as one page.

#include <string>
#include <vector>

#include "gradebook/marks/mark.hpp"

namespace cs550::gradebook {

/// Marks of every student with links to feedback/NAME.html, distribution per lab, hardest tests,
/// groups of alike failures, equal files, outliers.
std::string class_page(const std::vector<StudentMark>& marks, const std::vector<int>& labs,
                       const Course& course);

}  // namespace cs550::gradebook
