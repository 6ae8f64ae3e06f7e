#pragma once
/// @file gradescope_zip.hpp
/// The autograder that Gradescope runs.

#include <filesystem>
#include <string>

namespace cs550::gradebook {

struct GradescopeRequest {
  std::filesystem::path root;            ///< of the project
  std::string labs;                      ///< "3" or "1-7"; empty: all
  std::filesystem::path course, roster;  ///< may be empty
  std::filesystem::path out;             ///< the zip file
};

/// Packs the project as it is in the index of Git, with the scripts that Gradescope runs: setup.sh
/// builds the judges on its image and then removes solutions and hidden tests, run_autograder
/// grades a submission. Prints the entries of the course file that cannot have an effect there.
/// @throws std::runtime_error if the project is no Git checkout; std::invalid_argument for wrong
/// labs
void make_gradescope_zip(const GradescopeRequest& request);

}  // namespace cs550::gradebook
