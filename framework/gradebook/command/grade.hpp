#pragma once
/// @file grade.hpp
/// Grading submissions: from files to records and reports.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cs550::gradebook {

struct GradeRequest {
  std::filesystem::path root;  ///< of the project
  std::vector<std::filesystem::path> submissions;
  std::filesystem::path out;
  std::string labs;  ///< "1-7", "3", "1,3-5"; empty: all
  int jobs = 1;
  std::optional<bool> milestones;  ///< by default whether they have a weight
  bool resume = false;
  std::filesystem::path roster, course;  ///< may be empty
  std::filesystem::path metadata;        ///< Gradescope's, of the only submission; may be empty
  std::filesystem::path judge;           ///< the program grade_lab; empty: the project's own
  std::string isolation = "auto";
};

/// The labs that a text names: {1, 3, 4, 5} for "1,3-5".
/// Throws std::invalid_argument for any other text, such as 3-1, and for a lab that does not exist.
std::vector<int> parse_labs(const std::string& text, const std::vector<int>& known);

/// Prints what was graded. @return whether every submission has a mark
bool grade(const GradeRequest& request);

}  // namespace cs550::gradebook
