#pragma once
/// @file merge.hpp
/// One set of records from several folders, for example from several machines.

#include <vector>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// Whether two records are those of the same file, student, content and time.
bool same_submission(const Record& a, const Record& b);

/// Records of one submission, with the same name and of the same project, become one with the labs
/// of both; of two results for a lab the first that was graded counts, with the student's own tests
/// if it has them. The same holds for the milestones, with those that only the second result has.
/// Other records of the same name are kept under a new one.
std::vector<Record> merged(const std::vector<std::vector<Record>>& folders);

}  // namespace cs550::gradebook
