#pragma once
/// @file lab_path.hpp
/// Which lab a file of a submission belongs to.

#include <string>
#include <string_view>

#include "gradebook/course/catalogue.hpp"

namespace cs550::gradebook {

/// Where a file belongs, or why it is not taken.
struct LabPath {
  int lab = 0;                 ///< 0: to none
  std::string file;            ///< relative to the lab's folder
  std::string ignored;         ///< the reason; empty if the file is taken
  bool is_in_project = false;  ///< below labs/labN_topic/, as in the student's own copy
  std::string project;         ///< the folder of that copy; empty at the top
};

inline constexpr const char* outside_of_labs = "not in a lab's folder";

/// A file belongs to lab 3 if it is below labs/lab3_hill_climbing, else below a folder lab3_hill_climbing, else below
/// lab3, or if its name is that of one of the lab's starter files. Of such folders directly in each other the innermost
/// counts. Unsafe paths are refused: absolute ones and `..`;
/// from the lab's folder on also control characters and invalid UTF-8.
/// @param path as an archive or a folder has it, separated by / or \.
LabPath lab_path(std::string_view path, const Catalogue& catalogue);

}  // namespace cs550::gradebook
