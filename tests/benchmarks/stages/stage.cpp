#include "benchmarks/stages/stage.hpp"

#include <algorithm>

namespace cs550::bench {
namespace {

/// Keeps what Google Benchmark measures, and prints nothing.
class Recorder : public benchmark::BenchmarkReporter {
 public:
  Recorder(std::span<const Stage> stages, const std::function<void(int)>& finished)
      : stages_(stages), finished_(finished) {}

  bool ReportContext(const Context& /*context*/) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    const Stage& stage = stages_[costs.size()];
    for (const Run& run : runs) {
      const double seconds =
          run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
      costs.push_back({stage.name, stage.n, seconds / stage.items});
    }
    finished_(static_cast<int>(costs.size()));
  }

  std::vector<StageCost> costs;

 private:
  std::span<const Stage> stages_;
  const std::function<void(int)>& finished_;
};

void append(std::vector<Stage>& all, std::vector<Stage> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

std::vector<Stage> all_stages() {
  std::vector<Stage> all;
  append(all, integration_stages());
  append(all, broad_phase_stages());
  append(all, support_stages());
  append(all, gauss_map_stages());
  append(all, axis_stages());
  append(all, gjk_stages());
  append(all, manifold_stages());
  append(all, pass_stages());
  return all;
}

std::vector<int> doubled(int first, int last) {
  std::vector<int> sizes;
  for (int n = first; n <= last; n *= 2) sizes.push_back(n);
  return sizes;
}

std::string member(const std::string& family, int n) { return family + '/' + std::to_string(n); }

std::vector<StageCost> measure_stages(std::span<const Stage> stages, double seconds,
                                      const std::function<void(int)>& finished) {
  if (stages.empty()) return {};
  for (const Stage& stage : stages) {
    benchmark::RegisterBenchmark(stage.name.c_str(), stage.run)->MinTime(seconds);
  }
  Recorder recorder(stages, finished);
  benchmark::RunSpecifiedBenchmarks(&recorder, ".");
  benchmark::ClearRegisteredBenchmarks();
  return recorder.costs;
}

}  // namespace cs550::bench
