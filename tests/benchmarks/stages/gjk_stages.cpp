/// libccd's GJK and EPA on the hulls of axis/overlap.
#include "benchmarks/stages/gjk.hpp"
#include "benchmarks/stages/hull_pairs.hpp"
#include "benchmarks/stages/stage.hpp"

namespace cs550::bench {
namespace {

template <class Query>
void ask(benchmark::State& state, const HullPairs& hulls, const Query& query) {
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const HullPair& pair = hulls.pairs[next++ % hulls.pairs.size()];
    benchmark::DoNotOptimize(query(pair.a, pair.b));
  }
}

}  // namespace

std::vector<Stage> gjk_stages() {
  std::vector<Stage> stages;
  const auto add = [&](const std::string& family, int n, auto run) {
    stages.push_back({member(family, n), static_cast<double>(n), 1, std::move(run)});
  };
  const std::vector<int> sizes = doubled(8, 256);
  for (const int n : sizes) {
    add("gjk/overlap", n,
        [n](auto& state) { ask(state, HullPairs(n, Real(-0.1), 0), gjk_overlap); });
  }
  for (const int n : sizes) {
    add("gjk/apart", n,
        [n](auto& state) { ask(state, HullPairs(n, HullPairs::margin, 1), gjk_overlap); });
  }
  for (const int n : sizes) {
    add("epa/overlap", n, [n](auto& state) { ask(state, HullPairs(n, Real(-0.1), 0), epa_depth); });
  }
  return stages;
}

}  // namespace cs550::bench
