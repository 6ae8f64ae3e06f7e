#include "gradebook/run/reference_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cli/system/files.hpp"
#include "gradebook/run/worker_pool.hpp"

namespace cs550::gradebook {
namespace {

namespace fs = std::filesystem;

/// Without the subfolder of batched kernels.
LabFiles reference_files(const fs::path& folder) {
  LabFiles result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    result.files.push_back({entry.path().filename().string(), cli::read_text(entry.path())});
  }
  std::sort(result.files.begin(), result.files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return result;
}

void check_points(const LabRecord& record) {
  if (!record.not_graded.empty()) throw std::runtime_error(record.not_graded);
  for (const TestResult& test : record.tests) {
    if (test.earned == test.points) continue;
    throw std::runtime_error(
        fmt::format("The reference fails {} with the seeds that the secret of the course file "
                    "gives, so nobody would be graded fairly.\n  Choose another secret. "
                    "The test reports:\n{}",
                    test.name, test.message));
  }
}

}  // namespace

void check_reference(const fs::path& solutions, const std::vector<int>& labs, int jobs,
                     const Catalogue& catalogue, const Course& course, const Judge& judge,
                     const RecordFolder& folder, const std::atomic<bool>& stop) {
  const auto check = [&](std::size_t i) {
    const CatalogueLab& lab = catalogue.at(labs[i]);
    const LabFiles files = reference_files(solutions / lab.name);
    const std::string key = result_key(lab.number, files, course, judge);
    if (folder.result(key)) return;
    const LabRecord record = grade_lab(lab, files, course, judge, stop);
    if (stop) return;
    check_points(record);
    folder.store_result(key, record);
  };
  WorkerPool pool(jobs, labs.size(), check, stop);
  while (pool.is_busy()) pool.wait_for_finished();
}

}  // namespace cs550::gradebook
