#pragma once
/// @file gradescope_zip.hpp
/// The autograder that Gradescope runs.

#include <filesystem>
#include <string>

namespace cs550::gradebook {

/// Packs the project as it is in the index of Git, with the scripts that Gradescope runs: setup.sh
/// builds the judges on its image and then removes solutions and hidden tests, run_autograder
/// grades a submission.
/// @param labs "3" or "1-7"; empty: all
/// @param course may be empty
/// @throws std::runtime_error if the project is no Git checkout; std::invalid_argument for wrong
/// labs
void make_gradescope_zip(const std::filesystem::path& root, const std::string& labs,
                         const std::filesystem::path& course, const std::filesystem::path& out);

}  // namespace cs550::gradebook
