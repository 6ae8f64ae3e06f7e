#pragma once
/// @file reference_check.hpp
/// Whether the seeds that a course's secret gives are fair.

#include <vector>

#include "gradebook/records/record_folder.hpp"
#include "gradebook/run/grade_lab.hpp"

namespace cs550::gradebook {

/// Grades the reference of each lab, as a submission, with the secret of the course. A result is
/// kept, so that a secret is checked once.
/// @param solutions folder with the reference of each lab
/// @throws std::runtime_error if it does not earn every point
void check_reference(const std::filesystem::path& solutions, const std::vector<int>& labs, int jobs,
                     const Catalogue& catalogue, const Course& course, const Judge& judge,
                     const RecordFolder& folder, const std::atomic<bool>& stop);

}  // namespace cs550::gradebook
