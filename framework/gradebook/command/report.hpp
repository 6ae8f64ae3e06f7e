#pragma once
/// @file report.hpp
/// Reports made again from records.

#include <filesystem>
#include <vector>

#include "gradebook/records/record.hpp"

namespace cs550::gradebook {

struct ReportRequest {
  std::filesystem::path root;                  ///< of the project
  std::vector<std::filesystem::path> folders;  ///< outputs of the grader; several are merged
  std::filesystem::path out;                   ///< may be the only folder itself
  std::filesystem::path roster, course;        ///< may be empty: the first folder's copies
  bool pseudonyms = false;
};

/// The records of a folder. Throws std::runtime_error if there are none.
std::vector<Record> records_in(const std::filesystem::path& folder);

/// Throws std::invalid_argument for a request that makes no sense.
void report(const ReportRequest& request);

}  // namespace cs550::gradebook
