#include "gradebook/records/merge.hpp"

#include <algorithm>
#include <map>

namespace cs550::gradebook {
namespace {

bool belong_together(const Record& a, const Record& b) {
  return a.project == b.project && same_submission(a, b);
}

void add_milestones(Record& record, const Record& other) {
  if (!other.engine) return;
  if (!record.engine || !record.engine->not_graded.empty()) {
    record.engine = other.engine;
  } else if (other.engine->not_graded.empty()) {
    for (const TestResult& milestone : other.engine->tests) {
      if (!record.engine->has_test(milestone.name)) record.engine->tests.push_back(milestone);
    }
  }
}

void add_labs(Record& record, const Record& other) {
  add_milestones(record, other);
  for (const LabRecord& lab : other.labs) {
    const auto known = std::find_if(record.labs.begin(), record.labs.end(),
                                    [&lab](const LabRecord& l) { return l.lab == lab.lab; });
    const bool has_own_tests = lab.own_tests && lab.is_graded();
    if (known == record.labs.end()) {
      record.labs.push_back(lab);
    } else if (!known->not_graded.empty()) {
      *known = lab;
    } else if (!known->is_graded() && has_own_tests) {
      known->own_tests = lab.own_tests;
    }
  }
  std::sort(record.labs.begin(), record.labs.end(),
            [](const LabRecord& a, const LabRecord& b) { return a.lab < b.lab; });
}

}  // namespace

bool same_submission(const Record& a, const Record& b) {
  return a.hash == b.hash && a.student == b.student && a.claimed_student == b.claimed_student &&
         a.source == b.source && a.folders == b.folders && a.file_time == b.file_time &&
         a.claimed_date == b.claimed_date;
}

std::vector<Record> merged(const std::vector<std::vector<Record>>& folders) {
  std::map<std::string, Record> by_name;
  for (const std::vector<Record>& folder : folders) {
    for (Record record : folder) {
      const std::string base = record.name;
      auto known = by_name.find(record.name);
      for (int n = 2; known != by_name.end() && !belong_together(known->second, record); ++n) {
        record.name = base + '-' + std::to_string(n);
        known = by_name.find(record.name);
      }
      if (known == by_name.end()) {
        by_name[record.name] = record;
      } else {
        add_labs(known->second, record);
      }
    }
  }
  std::vector<Record> records;
  records.reserve(by_name.size());
  for (auto& [name, record] : by_name) records.push_back(std::move(record));
  return records;
}

}  // namespace cs550::gradebook
