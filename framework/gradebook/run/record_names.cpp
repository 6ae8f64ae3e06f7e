#include "gradebook/run/record_names.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace cs550::gradebook {

RecordNames::RecordNames(std::vector<Record> known, const std::vector<FoundSubmission>& found)
    : known_(std::move(known)) {
  for (const FoundSubmission& submission : found) paths_.insert(recorded_path(submission));
}

std::string RecordNames::name_for(const Submission& submission) {
  const Record* own = own_record(submission);
  std::string name = own == nullptr ? submission.name : own->name;
  for (int n = 2; own == nullptr && !is_free(name); ++n) {
    name = submission.name + '-' + std::to_string(n);
  }
  given_.insert(name);
  return name;
}

const Record* RecordNames::own_record(const Submission& submission) const {
  const auto find = [this](const auto& is_own) {
    const auto record = std::find_if(known_.begin(), known_.end(), [&](const Record& known) {
      return is_own(known) && !given_.contains(known.name);
    });
    return record == known_.end() ? nullptr : &*record;
  };
  if (const Record* record =
          find([&](const Record& known) { return known.path == submission.path; })) {
    return record;
  }
  // The folder of submissions may have been moved, or be another one on another machine. What is still in its place
  // was handed in, too.
  return find([&](const Record& known) {
    std::error_code is_gone;
    return known.source == submission.source && known.student == submission.student &&
           known.folders == submission.folders && known.hash == submission.hash() &&
           known.file_time == submission.file_time &&
           known.claimed_date == submission.claimed_date && !paths_.contains(known.path) &&
           !std::filesystem::exists(known.path, is_gone);
  });
}

bool RecordNames::is_free(const std::string& name) const {
  return !given_.contains(name) &&
         std::none_of(known_.begin(), known_.end(),
                      [&name](const Record& record) { return record.name == name; });
}

}  // namespace cs550::gradebook
