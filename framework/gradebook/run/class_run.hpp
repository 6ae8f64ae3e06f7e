#pragma once
/// @file class_run.hpp
/// Grading all labs of all submissions, several at a time.

#include <functional>
#include <vector>

#include "gradebook/intake/discovery.hpp"
#include "gradebook/records/record_folder.hpp"
#include "gradebook/run/grade_lab.hpp"

namespace cs550::gradebook {

/// What is to be graded.
struct ClassRun {
  std::vector<FoundSubmission> submissions;
  std::vector<int> labs;
  bool milestones = true;  ///< whether the first labs together run the milestones
  int jobs = 1;            ///< labs graded at the same time
  std::function<void(int, int)> on_progress;  ///< (done, total), called from one thread
};

struct ClassOutcome {
  int submissions = 0;       ///< with a record
  int runs = 0;              ///< of the judge
  int known = 0;             ///< results that needed no run: equal files, or an earlier run
  bool interrupted = false;  ///< records of unfinished submissions were not written
};

/// Grades and writes a record per submission. Results of labs are stored as soon as they are known,
/// so that a run that was interrupted is continued by the same call.
/// @param stop ends the run when it becomes true
/// Throws std::runtime_error if the folder cannot be written.
ClassOutcome grade_class(const ClassRun& run, const Catalogue& catalogue, const Course& course,
                         const Judge& judge, const RecordFolder& folder,
                         const std::atomic<bool>& stop);

}  // namespace cs550::gradebook
