#pragma once
/// @file record_names.hpp
/// The names of the records of a run, in a folder that may have records already.

#include <set>
#include <string>
#include <vector>

#include "gradebook/intake/discovery.hpp"
#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

/// A submission replaces its own record of an earlier run, and never that of another submission.
class RecordNames {
 public:
  /// @param known the records of the folder
  /// @param found the submissions of this run
  RecordNames(std::vector<Record> known, const std::vector<FoundSubmission>& found);

  /// The name of the record of the same path, or else of the same file name, content and time, if
  /// its path is gone. If there is none, it is the name of the submission, with a number if another
  /// record has that.
  std::string name_for(const Submission& submission);

 private:
  const Record* own_record(const Submission& submission) const;
  bool is_free(const std::string& name) const;

  std::vector<Record> known_;
  std::set<std::string> paths_;  ///< of the submissions of this run
  std::set<std::string> given_;  ///< names that the run has used
};

}  // namespace cs550::gradebook
