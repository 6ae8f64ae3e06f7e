#pragma once
/// @file gradescope_upload.hpp
/// What Gradescope hands to an autograder: one upload, and who made it.

#include <filesystem>
#include <vector>

#include "gradebook/intake/discovery.hpp"

namespace cs550::gradebook {

/// The only submission of an upload, with its time and its student from submission_metadata.json. Folders
/// without a file of a lab, such as __MACOSX, do not count. Several submissions are not graded: one of
/// them gets a trouble that names them.
/// @param found at least one
/// Throws std::runtime_error if the metadata have no time.
FoundSubmission gradescope_upload(const std::vector<FoundSubmission>& found,
                                  const std::filesystem::path& metadata,
                                  const Catalogue& catalogue);

}  // namespace cs550::gradebook
